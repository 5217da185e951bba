(* SPDX-License-Identifier: MIT *)
(* The error of a formula of sums, differences and products in machine numbers, and the test that
   decides its sign. Statements in words: docs/math/formal.md. *)
Require Import Reals Lra Lia Psatz.
Open Scope R_scope.

Definition eps : R := / 2 ^ 52.
Definition eta : R := / 2 ^ 1020.
Definition tiny : R := / 2 ^ 200.

(* One operation, read by the next: at most a relative error eps and an absolute one eta. *)
Definition rounds (x z : R) : Prop := Rabs (z - x) <= eps * Rabs x + eta.

Inductive expression : Type :=
  | given (x : R)            (* an input, which may be read as zero where it is subnormal *)
  | offset (p q : R)         (* the difference q - p of two inputs *)
  | absolute (a : expression)
  | half (a : expression)    (* a multiplication by 1/2, charged like any other operation *)
  | sum (a b : expression)
  | difference (a b : expression)
  | product (a b : expression).

Fixpoint exact (e : expression) : R :=
  match e with
  | given x => x
  | offset p q => q - p
  | absolute a => Rabs (exact a)
  | half a => exact a / 2
  | sum a b => exact a + exact b
  | difference a b => exact a - exact b
  | product a b => exact a * exact b
  end.

(* The sum of the absolute values of the monomials in inputs and offsets. *)
Fixpoint magnitude (e : expression) : R :=
  match e with
  | given x => Rabs x
  | offset p q => Rabs (q - p)
  | absolute a => magnitude a
  | half a => magnitude a / 2
  | sum a b | difference a b => magnitude a + magnitude b
  | product a b => magnitude a * magnitude b
  end.

(* The largest number of factors 1 + delta on a monomial. *)
Fixpoint depth (e : expression) : nat :=
  match e with
  | given _ => 0
  | offset _ _ => 1
  | absolute a => depth a
  | half a => S (depth a)
  | sum a b | difference a b => S (max (depth a) (depth b))
  | product a b => S (depth a + depth b)
  end.

(* What a machine may make of an expression. *)
Inductive computes : expression -> R -> Prop :=
  | computes_given x z : Rabs (z - x) <= eta -> computes (given x) z
  | computes_offset p q z : rounds (q - p) z -> computes (offset p q) z
  | computes_absolute a x : computes a x -> computes (absolute a) (Rabs x)
  | computes_half a x z : computes a x -> rounds (x / 2) z -> computes (half a) z
  | computes_sum a b x y z : computes a x -> computes b y -> rounds (x + y) z ->
      computes (sum a b) z
  | computes_difference a b x y z : computes a x -> computes b y -> rounds (x - y) z ->
      computes (difference a b) z
  | computes_product a b x y z : computes a x -> computes b y -> rounds (x * y) z ->
      computes (product a b) z.

(* All inputs and offsets are at most 2^201. *)
Fixpoint in_range (e : expression) : Prop :=
  match e with
  | given x => Rabs x <= 2 ^ 201
  | offset p q => Rabs (q - p) <= 2 ^ 201
  | absolute a | half a => in_range a
  | sum a b | difference a b | product a b => in_range a /\ in_range b
  end.

(* A bound of the magnitude in range, and of what the absolute errors add up to. *)
Fixpoint largest (e : expression) : R :=
  match e with
  | given _ | offset _ _ => 2 ^ 201
  | absolute a => largest a
  | half a => largest a
  | sum a b | difference a b => largest a + largest b
  | product a b => largest a * largest b
  end.

Fixpoint absolute_error (e : expression) : R :=
  match e with
  | given _ | offset _ _ => eta
  | absolute a => absolute_error a
  | half a => (1 + eps) * absolute_error a + eta
  | sum a b | difference a b => (1 + eps) * (absolute_error a + absolute_error b) + eta
  | product a b =>
      (1 + eps) * ((1 + eps) ^ depth a * largest a * absolute_error b +
                   (1 + eps) ^ depth b * largest b * absolute_error a +
                   absolute_error a * absolute_error b) + eta
  end.

Lemma eps_positive : 0 < eps.
Proof. unfold eps; apply Rinv_0_lt_compat, pow_lt; lra. Qed.
Lemma eta_positive : 0 < eta.
Proof. unfold eta; apply Rinv_0_lt_compat, pow_lt; lra. Qed.
Lemma power_at_least_1 n : 1 <= (1 + eps) ^ n.
Proof. apply pow_R1_Rle; pose proof eps_positive; lra. Qed.
Lemma power_grows m n : (m <= n)%nat -> (1 + eps) ^ m <= (1 + eps) ^ n.
Proof. intro; apply Rle_pow; [pose proof eps_positive; lra | assumption]. Qed.

Lemma magnitude_not_negative e : 0 <= magnitude e.
Proof.
  induction e; simpl; try apply Rabs_pos; try lra; try assumption.
  apply Rmult_le_pos; assumption.
Qed.

Lemma exact_at_most_magnitude e : Rabs (exact e) <= magnitude e.
Proof.
  induction e; simpl; try lra.
  - rewrite Rabs_Rabsolu; assumption.
  - unfold Rdiv; rewrite Rabs_mult, (Rabs_right (/ 2)); lra.
  - eapply Rle_trans; [apply Rabs_triang | lra].
  - unfold Rminus; eapply Rle_trans; [apply Rabs_triang | rewrite Rabs_Ropp; lra].
  - rewrite Rabs_mult; apply Rmult_le_compat; auto using Rabs_pos.
Qed.

Lemma magnitude_at_most_largest e : in_range e -> magnitude e <= largest e.
Proof.
  induction e; simpl; intros; try tauto; try lra.
  - specialize (IHe H); pose proof (magnitude_not_negative e); lra.
  - destruct H; specialize (IHe1 H); specialize (IHe2 H0); lra.
  - destruct H; specialize (IHe1 H); specialize (IHe2 H0); lra.
  - destruct H; apply Rmult_le_compat; auto using magnitude_not_negative.
Qed.

Lemma absolute_error_not_negative e : 0 <= absolute_error e /\ 0 < largest e.
Proof.
  pose proof eps_positive; pose proof eta_positive.
  assert (0 < 2 ^ 201) by (apply pow_lt; lra).
  induction e; cbn -[pow]; try (split; [ | lra]); try lra; try tauto.
  - nra.
  - nra.
  - nra.
  - split; [ | nra].
    destruct IHe1, IHe2.
    pose proof (power_at_least_1 (depth e1)); pose proof (power_at_least_1 (depth e2)).
    assert (0 <= (1 + eps) ^ depth e1 * largest e1) by nra.
    assert (0 <= (1 + eps) ^ depth e2 * largest e2) by nra.
    assert (0 <= (1 + eps) ^ depth e1 * largest e1 * absolute_error e2) by nra.
    assert (0 <= (1 + eps) ^ depth e2 * largest e2 * absolute_error e1) by nra.
    assert (0 <= absolute_error e1 * absolute_error e2) by nra.
    nra.
Qed.

(* A value within (k - 1) m + a of x, |x| <= m, rounded once more. *)
Lemma round_once x y z k m a :
  1 <= k -> 0 <= a -> Rabs x <= m -> Rabs (y - x) <= (k - 1) * m + a -> rounds y z ->
  Rabs (z - x) <= ((1 + eps) * k - 1) * m + ((1 + eps) * a + eta).
Proof.
  unfold rounds; intros hk ha hx hy hz; pose proof eps_positive.
  assert (Rabs y <= k * m + a).
  { replace y with ((y - x) + x) by ring. eapply Rle_trans; [apply Rabs_triang | lra]. }
  replace (z - x) with ((z - y) + (y - x)) by ring.
  eapply Rle_trans; [apply Rabs_triang | ].
  assert (eps * Rabs y <= eps * (k * m + a)) by (apply Rmult_le_compat_l; lra).
  lra.
Qed.


Theorem error_of_a_formula e z :
  in_range e -> computes e z ->
  Rabs (z - exact e) <= ((1 + eps) ^ depth e - 1) * magnitude e + absolute_error e.
Proof.
  intros range c; revert range; induction c; simpl in_range; intro range;
    pose proof eps_positive as pe; pose proof eta_positive as ph.
  - cbn -[pow]; simpl pow; lra.
  - unfold rounds in H; cbn -[pow]; rewrite pow_1; lra.
  - cbn -[pow]; specialize (IHc range).
    eapply Rle_trans; [apply Rabs_triang_inv2 | exact IHc].
  - cbn -[pow]; specialize (IHc range); rewrite <- tech_pow_Rmult.
    eapply Rle_trans; [apply (round_once _ (x / 2) z ((1 + eps) ^ depth a) (magnitude a / 2)
                                (absolute_error a)) | ].
    + apply power_at_least_1.
    + apply absolute_error_not_negative.
    + unfold Rdiv; rewrite Rabs_mult, (Rabs_right (/ 2)) by lra.
      pose proof (exact_at_most_magnitude a); lra.
    + replace (x / 2 - exact a / 2) with ((x - exact a) * / 2) by field.
      rewrite Rabs_mult, (Rabs_right (/ 2)) by lra.
      pose proof (proj1 (absolute_error_not_negative a)); lra.
    + assumption.
    + lra.
  - cbn -[pow]; destruct range as [ra rb]; specialize (IHc1 ra); specialize (IHc2 rb).
    rewrite <- tech_pow_Rmult.
    apply (round_once _ (x + y)); try assumption.
    + apply power_at_least_1.
    + pose proof (proj1 (absolute_error_not_negative a));
      pose proof (proj1 (absolute_error_not_negative b)); lra.
    + exact (exact_at_most_magnitude (sum a b)).
    + replace (x + y - (exact a + exact b)) with ((x - exact a) + (y - exact b)) by ring.
      eapply Rle_trans; [apply Rabs_triang | ].
      pose proof (power_grows _ _ (Nat.le_max_l (depth a) (depth b))).
      pose proof (power_grows _ _ (Nat.le_max_r (depth a) (depth b))).
      pose proof (magnitude_not_negative a); pose proof (magnitude_not_negative b).
      nra.
  - cbn -[pow]; destruct range as [ra rb]; specialize (IHc1 ra); specialize (IHc2 rb).
    rewrite <- tech_pow_Rmult.
    apply (round_once _ (x - y)); try assumption.
    + apply power_at_least_1.
    + pose proof (proj1 (absolute_error_not_negative a));
      pose proof (proj1 (absolute_error_not_negative b)); lra.
    + exact (exact_at_most_magnitude (difference a b)).
    + replace (x - y - (exact a - exact b)) with ((x - exact a) + - (y - exact b)) by ring.
      eapply Rle_trans; [apply Rabs_triang | rewrite Rabs_Ropp].
      pose proof (power_grows _ _ (Nat.le_max_l (depth a) (depth b))).
      pose proof (power_grows _ _ (Nat.le_max_r (depth a) (depth b))).
      pose proof (magnitude_not_negative a); pose proof (magnitude_not_negative b).
      nra.
  - cbn -[pow]; destruct range as [ra rb]; specialize (IHc1 ra); specialize (IHc2 rb).
    rewrite <- tech_pow_Rmult, pow_add.
    destruct (absolute_error_not_negative a) as [ua la], (absolute_error_not_negative b) as [ub lb].
    pose proof (power_at_least_1 (depth a)) as pa; pose proof (power_at_least_1 (depth b)) as pb.
    pose proof (magnitude_not_negative a) as ma; pose proof (magnitude_not_negative b) as mb.
    pose proof (magnitude_at_most_largest a ra) as ga.
    pose proof (magnitude_at_most_largest b rb) as gb.
    pose proof (exact_at_most_magnitude a) as ea; pose proof (exact_at_most_magnitude b) as eb.
    set (ka := (1 + eps) ^ depth a) in *; set (kb := (1 + eps) ^ depth b) in *.
    set (A := absolute_error a) in *; set (B := absolute_error b) in *.
    apply (round_once _ (x * y)); try assumption.
    + nra.
    + assert (0 <= ka * largest a * B) by (repeat apply Rmult_le_pos; lra).
      assert (0 <= kb * largest b * A) by (repeat apply Rmult_le_pos; lra).
      assert (0 <= A * B) by (apply Rmult_le_pos; lra). lra.
    + exact (exact_at_most_magnitude (product a b)).
    + replace (x * y - exact a * exact b) with
        ((x - exact a) * (y - exact b) + ((x - exact a) * exact b + exact a * (y - exact b)))
        by ring.
      eapply Rle_trans; [apply Rabs_triang | ].
      eapply Rle_trans; [apply Rplus_le_compat_l, Rabs_triang | ].
      rewrite 3!Rabs_mult.
      set (dx := Rabs (x - exact a)) in *; set (dy := Rabs (y - exact b)) in *.
      assert (0 <= dx) by apply Rabs_pos. assert (0 <= dy) by apply Rabs_pos.
      set (P := (ka - 1) * magnitude a + A) in *; set (Q := (kb - 1) * magnitude b + B) in *.
      assert (0 <= (ka - 1) * magnitude a) by (apply Rmult_le_pos; lra).
      assert (0 <= (kb - 1) * magnitude b) by (apply Rmult_le_pos; lra).
      assert (dx * dy <= P * Q) by (apply Rmult_le_compat; lra).
      assert (dx * Rabs (exact b) <= P * magnitude b)
        by (apply Rmult_le_compat; auto using Rabs_pos).
      assert (Rabs (exact a) * dy <= magnitude a * Q)
        by (apply Rmult_le_compat; auto using Rabs_pos).
      assert (ka * magnitude a * B <= ka * largest a * B)
        by (apply Rmult_le_compat_r; [lra | apply Rmult_le_compat_l; lra]).
      assert (kb * magnitude b * A <= kb * largest b * A)
        by (apply Rmult_le_compat_r; [lra | apply Rmult_le_compat_l; lra]).
      unfold P, Q in *; nra.
Qed.

Lemma Rabs_le_inv x y : Rabs x <= y -> - y <= x <= y.
Proof. unfold Rabs; destruct (Rcase_abs x); lra. Qed.

(* The factor: (1 + eps)^d - 1, with the roundings of a magnitude up to 13 operations deep and of
   the bound made from it, is at most (d + 8) eps. *)
Lemma factor_suffices d :
  (d <= 13)%nat ->
  (1 + eps) ^ d - 1 <= (1 - eps) * (1 - eps) * (2 - (1 + eps) ^ 13) * ((INR d + 8) * eps).
Proof.
  intro h; unfold eps.
  do 14 (destruct d as [ | d]; [simpl INR; lra | ]); lia.
Qed.

(* A bound of a formula's absolute error that lets `tiny` pay for it. *)
Definition harmless : R := / 2 ^ 203.

Theorem sign_is_decided e s k d z w b c :
  (depth e <= d)%nat -> (d <= 13)%nat -> (depth s <= 13)%nat -> 0 < k <= 4 ->
  in_range e -> in_range s ->
  absolute_error e <= harmless -> absolute_error s <= harmless ->
  exact s = magnitude s -> magnitude e <= k * magnitude s ->
  computes e z -> computes s w ->
  rounds (k * ((INR d + 8) * eps) * w) b -> rounds (b + tiny) c ->
  c < Rabs z -> 0 < z * exact e.
Proof.
  intros de d13 ds hk re rs ue us hs hm ce cs hb hc decided.
  pose proof (error_of_a_formula e z re ce) as fe.
  pose proof (error_of_a_formula s w rs cs) as fs.
  pose proof (factor_suffices d d13) as suffices.
  pose proof (power_grows _ _ de) as ge; pose proof (power_grows _ _ ds) as gs.
  pose proof (magnitude_not_negative s) as ms; pose proof (magnitude_not_negative e) as me.
  pose proof eps_positive as pe.
  assert (small : eps <= / 1000) by (unfold eps; lra).
  assert (hd : 0 <= INR d <= 13).
  { split; [apply pos_INR | ]. replace 13 with (INR 13) by (simpl; lra). apply le_INR; assumption. }
  assert (pt : 0 < tiny) by (unfold tiny; apply Rinv_0_lt_compat, pow_lt; lra).
  assert (ph : 0 < eta) by apply eta_positive.
  assert (phh : 0 < harmless) by (unfold harmless; apply Rinv_0_lt_compat, pow_lt; lra).
  set (f := (INR d + 8) * eps) in *.
  assert (f_range : 0 < f <= 21 * eps) by (unfold f; nra).
  set (K := (1 + eps) ^ 13) in *.
  assert (hK : 1 <= K <= 2) by (unfold K; split;
    [apply power_at_least_1 | unfold eps; lra]).
  set (m := magnitude s) in *.
  (* the computed magnitude from below *)
  assert (w_low : (2 - K) * m - harmless <= w).
  { rewrite hs in fs. apply Rabs_le_inv in fs.
    assert ((1 + eps) ^ depth s * m <= K * m) by (apply Rmult_le_compat_r; lra). lra. }
  set (v := k * f * w) in *.
  assert (kf : 0 < k * f <= 4 * (21 * eps)).
  { split; [apply Rmult_lt_0_compat; lra | apply Rmult_le_compat; lra]. }
  assert (v_low : k * f * ((2 - K) * m) - k * f * harmless <= v).
  { unfold v. assert (k * f * ((2 - K) * m - harmless) <= k * f * w)
      by (apply Rmult_le_compat_l; lra). lra. }
  assert (kfh : k * f * harmless <= 4 * (21 * eps) * harmless)
    by (apply Rmult_le_compat_r; lra).
  assert (kfh0 : 0 <= k * f * harmless) by (apply Rmult_le_pos; lra).
  set (g := k * f * ((2 - K) * m)) in *.
  assert (g0 : 0 <= g) by (unfold g; apply Rmult_le_pos; [lra | apply Rmult_le_pos; lra]).
  assert (b_low : (1 - eps) * g - 2 * (k * f * harmless) - eta <= b).
  { unfold rounds in hb; apply Rabs_le_inv in hb.
    destruct (Rle_dec 0 v) as [vp | vn].
    - rewrite (Rabs_right v) in hb by lra. nra.
    - rewrite (Rabs_left v) in hb by lra. nra. }
  assert (tails : 2 * (4 * (21 * eps) * harmless) + 4 * eta + harmless < tiny / 2)
    by (unfold eps, harmless, eta, tiny; lra).
  assert (bt : 0 <= b + tiny) by nra.
  assert (c_low : (1 - eps) * (b + tiny) - eta <= c).
  { unfold rounds in hc; apply Rabs_le_inv in hc.
    rewrite (Rabs_right (b + tiny)) in hc by lra. lra. }
  assert (b_part : (1 - eps) * ((1 - eps) * g + (tiny - 2 * (k * f * harmless) - eta)) <=
                   (1 - eps) * (b + tiny)) by (apply Rmult_le_compat_l; lra).
  assert (rest : tiny / 2 + harmless <=
                 (1 - eps) * (tiny - 2 * (k * f * harmless) - eta) - eta + tiny / 4).
  { set (T := tiny - 2 * (k * f * harmless) - eta).
    assert (0 <= T) by (unfold T; lra).
    assert (eps * T <= / 1000 * T) by (apply Rmult_le_compat_r; lra).
    unfold T in *; lra. }
  assert (e_up : ((1 + eps) ^ depth e - 1) * magnitude e <= (1 - eps) * ((1 - eps) * g)).
  { apply Rle_trans with (((1 + eps) ^ d - 1) * (k * m)).
    - apply Rmult_le_compat; try lra. pose proof (power_at_least_1 (depth e)); lra.
    - replace ((1 - eps) * ((1 - eps) * g)) with
        ((1 - eps) * (1 - eps) * (2 - K) * f * (k * m)) by (unfold g; ring).
      apply Rmult_le_compat_r; [apply Rmult_le_pos; lra | exact suffices]. }
  assert (near : Rabs (z - exact e) < Rabs z) by lra.
  clear - near.
  unfold Rabs in near; destruct (Rcase_abs (z - exact e)), (Rcase_abs z); nra.
Qed.
