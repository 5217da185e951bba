(* SPDX-License-Identifier: MIT *)
(* Ties: points that several sites are equally far from. What docs/math/proof-format.md, theorem 3, and the
   meeting lemma of docs/math/certificate.md, 4.3, say of them, and the rule of docs/math/ties.md.
   Statements in words: docs/math/formal.md. *)
Require Import Reals Lra Lia Psatz List.
From formal Require Import geometry counting meeting.
Import ListNotations.
Open Scope R_scope.

(* Closed cells: of the sites that a list numbers, at the squared distances f. *)
Section cells.
Variables (f : nat -> R) (sites : list nat).
Definition is_nearest v := In v sites /\ forall w, In w sites -> f v <= f w.
(* Owns the point: nearest, and before all others as near, in the order of their numbers. *)
Definition is_owner v := is_nearest v /\ forall w, is_nearest w -> (v <= w)%nat.

Theorem tied_cells_share_the_point v w :
  is_nearest v -> In w sites -> (is_nearest w <-> f w = f v).
Proof.
  intros [iv nv] iw; split.
  - intros [_ nw]. pose proof (nv w iw); pose proof (nw v iv); lra.
  - intro e; split; [assumption | ]. intros u iu; rewrite e; apply nv; assumption.
Qed.

Lemma some_are_nearest : sites <> [] -> exists v, is_nearest v.
Proof.
  unfold is_nearest. induction sites as [ | s l IH]; [congruence | intros _].
  destruct l as [ | t l].
  - exists s; split; [left; reflexivity | intros w [<- | []]; lra].
  - destruct IH as (v & iv & nv); [congruence | ].
    destruct (Rle_or_lt (f s) (f v)) as [le | lt].
    + exists s; split; [left; reflexivity | ]. intros w [<- | h]; [lra | ].
      pose proof (nv w h); lra.
    + exists v; split; [right; assumption | ]. intros w [<- | h]; [lra | apply nv; assumption].
Qed.

Theorem one_owner : sites <> [] -> exists v, is_owner v /\ forall w, is_owner w -> w = v.
Proof.
  intro some. destruct (some_are_nearest some) as (n & near).
  set (tied := filter (fun w => if Req_EM_T (f w) (f n) then true else false) sites).
  assert (all : forall w, In w tied <-> is_nearest w).
  { intro w; unfold tied; rewrite filter_In. destruct (Req_EM_T (f w) (f n)) as [e | ne].
    - split; [intros [iw _]; apply (tied_cells_share_the_point n w near iw); assumption | ].
      intros [iw _]; split; [assumption | reflexivity].
    - split; [intros [_ no]; discriminate | ]. intro nw; exfalso; apply ne.
      apply (tied_cells_share_the_point n w near (proj1 nw)); assumption. }
  assert (least : forall l : list nat, l <> [] -> exists v, In v l /\ forall w, In w l -> (v <= w)%nat).
  { clear. induction l as [ | s l IH]; [congruence | intros _].
    destruct l as [ | t l].
    - exists s; split; [left; reflexivity | intros w [<- | []]; lia].
    - destruct IH as (v & iv & lv); [congruence | ].
      destruct (Compare_dec.le_lt_dec s v) as [le | lt].
      + exists s; split; [left; reflexivity | ]. intros w [<- | h]; [lia | pose proof (lv w h); lia].
      + exists v; split; [right; assumption | ]. intros w [<- | h]; [lia | apply lv; assumption]. }
  destruct (least tied) as (v & iv & lv).
  { intro none. assert (In n tied) as there by (apply all; assumption). rewrite none in there; destruct there. }
  exists v; split.
  - split; [apply all; assumption | intros w nw; apply lv, all; assumption].
  - intros w [nw lw]. pose proof (lw v (proj1 (all v) iv)); pose proof (lv w (proj2 (all w) nw)); lia.
Qed.
End cells.

(* Limits. At a tie p is a limit of points that are good: q n goes to p. *)
Lemma cv_constant c : Un_cv (fun _ => c) c.
Proof. intros e he; exists 0%nat; intros; unfold R_dist; rewrite Rminus_diag_eq, Rabs_R0 by reflexivity; assumption. Qed.

Lemma in_the_end_positive f l : Un_cv f l -> 0 < l -> exists N, forall n, (N <= n)%nat -> 0 < f n.
Proof.
  intros cv pos; destruct (cv l pos) as (N & near). exists N; intros n hn.
  pose proof (near n hn) as close. unfold R_dist in close. apply Rabs_def2 in close. lra.
Qed.

Lemma limit_not_positive f l : Un_cv f l -> (exists N, forall n, (N <= n)%nat -> f n <= 0) -> l <= 0.
Proof.
  intros cv (M & no). apply Rnot_lt_le; intro pos.
  destruct (in_the_end_positive f l cv pos) as (N & more).
  pose proof (more (max M N) ltac:(lia)); pose proof (no (max M N) ltac:(lia)); lra.
Qed.

Ltac goes :=
  match goal with
  | |- Un_cv (fun _ => ?c) ?c => exact (cv_constant c)
  | |- _ => assumption
  | |- Un_cv _ (?a + ?b) => apply CV_plus; goes
  | |- Un_cv _ (?a - ?b) => apply CV_minus; goes
  | |- Un_cv _ (?a * ?b) => apply CV_mult; goes
  end.

Section limits.
Variables (V Z : metric) (dx dy : R).
Hypothesis (hv : positive_definite V) (hz : positive_definite Z) (hd : dx <> 0 \/ dy <> 0).

Lemma nearer_up_to_where_it_dominates px py :
  0 < sees V dx dy px py -> dominates V Z dx dy px py ->
  forall t, 0 <= t <= 1 -> from_v V Z dx dy px py t < 0.
Proof.
  intros hp dom t ht. apply Rnot_le_lt; intro no.
  pose proof (at_v V Z dx dy hz hd px py) as start.
  pose proof (quadratic_continuous _ (from_v_quadratic V Z dx dy px py)) as cont.
  destruct (IVT_cor _ 0 t cont ltac:(lra)) as (r & hr & root); [nra | ].
  assert (r <> 0) by (intro; subst; lra).
  exact (first_meeting V Z dx dy hv hz hd px py r hp ltac:(lra) root dom).
Qed.

Variables (px py : R) (qx qy : nat -> R).
Hypothesis (to_x : Un_cv qx px) (to_y : Un_cv qy py).
Hypothesis (toward : 0 < sees V dx dy px py).
Hypothesis (good : forall n, dominates V Z dx dy (qx n) (qy n)).

Lemma limit_not_farther t : 0 <= t <= 1 -> from_v V Z dx dy px py t <= 0.
Proof.
  intro ht. apply limit_not_positive with (fun n => from_v V Z dx dy (qx n) (qy n) t).
  - unfold from_v, gap, square, inner; goes.
  - destruct (in_the_end_positive (fun n => sees V dx dy (qx n) (qy n)) (sees V dx dy px py)) as (N & hN).
    + unfold sees, inner; goes.
    + exact toward.
    + exists N; intros n hn; left; apply nearer_up_to_where_it_dominates;
        [apply hN; assumption | apply good | assumption].
Qed.

(* The lemma of 4.1 at a tie: p is on the bisector, and its ray has not met the bisector before. *)
Theorem first_meeting_at_a_tie t0 :
  gap V Z dx dy px py = 0 -> 0 < t0 < 1 -> 0 <= from_v V Z dx dy px py t0 -> False.
Proof.
  intros on ht reached. pose proof (limit_not_farther t0 ltac:(lra)) as below.
  assert (root : from_v V Z dx dy px py t0 = 0) by lra.
  pose proof (limit_not_farther ((t0 + 1) / 2) ltac:(lra)) as between.
  pose proof (at_v V Z dx dy hz hd px py) as start.
  destruct (at_p V Z dx dy px py) as [last _]. rewrite on in last.
  destruct (from_v_quadratic V Z dx dy px py) as (a & b & c & shape).
  rewrite shape in root, between, start, last.
  assert (hc : c < 0) by (simpl in start; lra).
  assert (hb : b = - a - c) by (simpl in last; lra). subst b.
  (* With zeros at t0 and 1 it is a (t - t0) (t - 1), and a t0 = c. *)
  assert (factor : (t0 - 1) * (a * t0 - c) = 0) by (simpl in root; lra).
  assert (hact : a * t0 = c).
  { apply Rmult_integral in factor; destruct factor; lra. }
  assert (ha : a < 0) by nra.
  assert (value : a * ((t0 + 1) / 2) ^ 2 + (- a - c) * ((t0 + 1) / 2) + c = - a * ((1 - t0) / 2) ^ 2)
    by (rewrite <- hact; field).
  rewrite value in between. assert (0 < ((1 - t0) / 2) ^ 2) by (apply pow_lt; lra). nra.
Qed.

(* Lemma 2 of proof-format.md at a tie: a segment behind z bounds where p can be. *)
Theorem row_bounds_a_tie cx cy ex ey a b :
  gap V Z dx dy px py = 0 ->
  (forall t, 0 <= t <= 1 ->
     0 <= gap V Z dx dy (cx + t * (ex - cx)) (cy + t * (ey - cy))) ->
  0 <= a -> 0 <= b -> 0 < a + b -> px = a * cx + b * ex -> py = a * cy + b * ey -> a + b <= 1.
Proof.
  intros on behind ha hb some epx epy. apply Rnot_lt_le; intro beyond.
  destruct (place_on_row a b ha hb some) as (ht & positive & less & place).
  set (s := 1 / (a + b)) in *. set (t := b / (a + b)) in *. specialize (less beyond).
  apply (first_meeting_at_a_tie s on (conj positive less)). unfold from_v.
  rewrite epx, epy, !place. apply behind; assumption.
Qed.
End limits.

(* Part (1) of the meeting lemma at a tie, with bounds b as in meeting.v. *)
Theorem tie_in_the_cone V X xx xy ux uy px py m n qx qy (b : R -> R -> R) :
  positive_definite V -> positive_definite X -> xx <> 0 \/ xy <> 0 ->
  0 <= m -> 0 <= n -> 0 < m + n -> px = m * xx + n * ux -> py = m * xy + n * uy ->
  Un_cv qx px -> Un_cv qy py -> (forall i, dominates V X xx xy (qx i) (qy i)) ->
  gap V X xx xy px py = 0 ->
  0 < inner V ux uy xx xy -> 0 < b xx xy -> 0 < b ux uy ->
  (forall k l, 0 <= k -> 0 <= l ->
     k * b xx xy + l * b ux uy <= b (k * xx + l * ux) (k * xy + l * uy)) ->
  (forall k l rx ry, 0 <= k -> 0 <= l -> rx = k * xx + l * ux -> ry = k * xy + l * uy -> 0 < b rx ry ->
     exists t, 0 < t /\ t * b rx ry <= 1 /\ gap V X xx xy (t * rx) (t * ry) = 0) ->
  m * b xx xy + n * b ux uy <= 1.
Proof.
  intros hv hx no hm hn some epx epy to_x to_y good on hu bx bu concave bound.
  apply Rnot_lt_le; intro beyond.
  assert (toward : 0 < sees V xx xy px py).
  { unfold sees. rewrite epx, epy. apply toward_in_the_cone; assumption. }
  pose proof (concave m n hm hn) as more. rewrite <- epx, <- epy in more.
  destruct (bound m n px py hm hn epx epy ltac:(lra)) as (t & ht & le & meets).
  assert (short : t < 1).
  { apply Rnot_le_lt; intro long. assert (1 * b px py <= t * b px py) by (apply Rmult_le_compat_r; lra). lra. }
  apply (first_meeting_at_a_tie V X xx xy hv hx no px py qx qy to_x to_y toward good t on (conj ht short)).
  unfold from_v; lra.
Qed.

(* Part (2) of the meeting lemma, kind (ii) of theorem 3 of proof-format.md, at a tie. *)
Section edge.
Variables (V W X : metric) (wx wy xx xy px py : R) (qx qy : nat -> R).
Hypothesis (hv : positive_definite V) (hw : positive_definite W) (hx : positive_definite X).
Hypothesis (w_is_not_v : wx <> 0 \/ wy <> 0) (x_is_not_v : xx <> 0 \/ xy <> 0).
Hypothesis (x_is_not_w : xx - wx <> 0 \/ xy - wy <> 0).
Hypothesis (to_x : Un_cv qx px) (to_y : Un_cv qy py).
Hypothesis (on : forall n, f_v V (qx n) (qy n) = f_w W wx wy (qx n) (qy n)).
Hypothesis (seen : 0 < inner V px py wx wy).
Hypothesis (good_of_v : forall n, v_dominates V X xx xy (qx n) (qy n)).
Hypothesis (good_of_w : forall n, w_dominates W X wx wy xx xy (qx n) (qy n)).
(* x is outside of the closed triangles v, w, q n. *)
Hypothesis (outside : forall n a b, 0 <= a -> 0 <= b -> xx = a * wx + b * qx n -> xy = a * wy + b * qy n -> 1 < a + b).

Definition cross ax ay bx by_ := ax * by_ - ay * bx.

Theorem tie_at_the_edge a b :
  0 < a -> 0 < b -> xx = a * wx + b * px -> xy = a * wy + b * py -> cross wx wy px py <> 0 ->
  exists s, 0 < s < 1 /\ let zx := s * xx in let zy := s * xy in
    f_w W wx wy zx zy <= f_v V zx zy /\ f_w W wx wy zx zy <= f_x X xx xy zx zy.
Proof.
  intros ha hb ex ey turned.
  set (k := cross wx wy px py) in *.
  assert (hk : 0 < k * k) by (apply Rsqr_pos_lt; assumption).
  set (N := fun n => k * cross wx wy (qx n) (qy n)).
  set (A := fun n => k * cross xx xy (qx n) (qy n)).
  set (B := k * cross wx wy xx xy).
  assert (eB : B = b * (k * k)) by (unfold B, k, cross; rewrite ex, ey; ring).
  assert (toN : Un_cv N (k * k)) by (unfold N, cross at 1; unfold k at 3, cross; goes).
  assert (eA : k * cross xx xy px py = a * (k * k)) by (unfold k, cross; rewrite ex, ey; ring).
  assert (toA : Un_cv A (a * (k * k))) by (rewrite <- eA; unfold A, cross; goes).
  assert (toI : Un_cv (fun n => inner V (qx n) (qy n) wx wy) (inner V px py wx wy)) by (unfold inner; goes).
  assert (pA : 0 < a * (k * k)) by (apply Rmult_lt_0_compat; assumption).
  assert (pB : 0 < B) by (rewrite eB; apply Rmult_lt_0_compat; assumption).
  destruct (in_the_end_positive N _ toN hk) as (n1 & h1).
  destruct (in_the_end_positive A _ toA pA) as (n2 & h2).
  destruct (in_the_end_positive _ _ toI seen) as (n3 & h3).
  set (D := fun n => A n + B).
  assert (toD : Un_cv D (a * (k * k) + B)) by (unfold D; goes).
  assert (each : forall n, (max n1 (max n2 n3) <= n)%nat ->
    N n < D n /\
    square W (N n * xx - D n * wx) (N n * xy - D n * wy) - square V (N n * xx) (N n * xy) <= 0 /\
    square W (N n * xx - D n * wx) (N n * xy - D n * wy) -
      square X ((N n - D n) * xx) ((N n - D n) * xy) <= 0).
  { intros n hn. pose proof (h1 n ltac:(lia)) as pN. pose proof (h2 n ltac:(lia)) as pAn.
    pose proof (h3 n ltac:(lia)) as pI. cbv beta in pI.
    set (an := A n / N n). set (bn := B / N n).
    assert (pan : 0 < an) by (apply Rdiv_lt_0_compat; assumption).
    assert (pbn : 0 < bn) by (apply Rdiv_lt_0_compat; assumption).
    assert (solve : forall u v, u * N n = v * A n -> u = v * an)
      by (intros u v e; unfold an; apply Rmult_eq_reg_r with (N n); [ | lra]; rewrite e; field; lra).
    assert (exn : xx = an * wx + bn * qx n).
    { apply Rmult_eq_reg_r with (N n); [ | lra]. unfold an, bn.
      replace ((A n / N n * wx + B / N n * qx n) * N n) with (A n * wx + B * qx n) by (field; lra).
      unfold A, B, N, cross; ring. }
    assert (eyn : xy = an * wy + bn * qy n).
    { apply Rmult_eq_reg_r with (N n); [ | lra]. unfold an, bn.
      replace ((A n / N n * wy + B / N n * qy n) * N n) with (A n * wy + B * qy n) by (field; lra).
      unfold A, B, N, cross; ring. }
    pose proof (outside n an bn ltac:(lra) ltac:(lra) exn eyn) as out.
    assert (sum : an + bn = D n / N n) by (unfold an, bn, D; field; lra).
    destruct (point_of_the_edge V W X wx wy xx xy (qx n) (qy n) hv hw hx w_is_not_v x_is_not_v x_is_not_w
                an bn (on n) pI (good_of_v n) (good_of_w n) pan pbn exn eyn out) as (s & hs & place & lv & lx).
    assert (pD : 0 < D n) by (unfold D; lra).
    assert (es : s = N n / D n).
    { apply Rmult_eq_reg_r with (an + bn); [ | lra]. rewrite place, sum; field; lra. }
    assert (eN : N n = s * D n) by (rewrite es; field; lra).
    cbv zeta in lv, lx. unfold f_w, f_v, f_x in lv, lx.
    assert (sq : 0 < D n * D n) by (apply Rmult_lt_0_compat; assumption).
    split; [rewrite eN; nra | ].
    assert (eW : square W (N n * xx - D n * wx) (N n * xy - D n * wy) =
      D n * D n * square W (s * xx - wx) (s * xy - wy)) by (rewrite eN; unfold square, inner; ring).
    assert (eV : square V (N n * xx) (N n * xy) = D n * D n * square V (s * xx) (s * xy))
      by (rewrite eN; unfold square, inner; ring).
    assert (eX : square X ((N n - D n) * xx) ((N n - D n) * xy) =
      D n * D n * square X (s * xx - xx) (s * xy - xy)) by (rewrite eN; unfold square, inner; ring).
    rewrite eW, eV, eX. split.
    - assert (D n * D n * square W (s * xx - wx) (s * xy - wy) <= D n * D n * square V (s * xx) (s * xy))
        by (apply Rmult_le_compat_l; lra). lra.
    - assert (D n * D n * square W (s * xx - wx) (s * xy - wy) <= D n * D n * square X (s * xx - xx) (s * xy - xy))
        by (apply Rmult_le_compat_l; lra). lra. }
  set (d := a * (k * k) + B) in *.
  assert (ed : d = (a + b) * (k * k)) by (unfold d; rewrite eB; ring).
  assert (pd : 0 < d) by (unfold d; lra).
  assert (le : k * k - d <= 0).
  { apply limit_not_positive with (fun n => N n - D n); [goes | ].
    exists (max n1 (max n2 n3)); intros n hn. destruct (each n hn); lra. }
  assert (by_v : square W (k * k * xx - d * wx) (k * k * xy - d * wy) - square V (k * k * xx) (k * k * xy) <= 0).
  { apply limit_not_positive with (fun n => square W (N n * xx - D n * wx) (N n * xy - D n * wy) -
      square V (N n * xx) (N n * xy)).
    - unfold square, inner; goes.
    - exists (max n1 (max n2 n3)); intros n hn. destruct (each n hn) as (_ & h & _); exact h. }
  assert (by_x : square W (k * k * xx - d * wx) (k * k * xy - d * wy) -
      square X ((k * k - d) * xx) ((k * k - d) * xy) <= 0).
  { apply limit_not_positive with (fun n => square W (N n * xx - D n * wx) (N n * xy - D n * wy) -
      square X ((N n - D n) * xx) ((N n - D n) * xy)).
    - unfold square, inner; goes.
    - exists (max n1 (max n2 n3)); intros n hn. destruct (each n hn) as (_ & _ & h); exact h. }
  set (s := k * k / d).
  assert (es : k * k = s * d) by (unfold s; field; lra).
  assert (ps : 0 < s) by (apply Rdiv_lt_0_compat; assumption).
  assert (sq : 0 < d * d) by (apply Rmult_lt_0_compat; assumption).
  rewrite es in by_v, by_x.
  assert (lv : square W (s * xx - wx) (s * xy - wy) <= square V (s * xx) (s * xy)).
  { apply Rmult_le_reg_l with (d * d); [assumption | ].
    replace (d * d * square W (s * xx - wx) (s * xy - wy))
      with (square W (s * d * xx - d * wx) (s * d * xy - d * wy)) by (unfold square, inner; ring).
    replace (d * d * square V (s * xx) (s * xy)) with (square V (s * d * xx) (s * d * xy))
      by (unfold square, inner; ring). lra. }
  assert (lx : square W (s * xx - wx) (s * xy - wy) <= square X (s * xx - xx) (s * xy - xy)).
  { apply Rmult_le_reg_l with (d * d); [assumption | ].
    replace (d * d * square W (s * xx - wx) (s * xy - wy))
      with (square W (s * d * xx - d * wx) (s * d * xy - d * wy)) by (unfold square, inner; ring).
    replace (d * d * square X (s * xx - xx) (s * xy - xy))
      with (square X ((s * d - d) * xx) ((s * d - d) * xy)) by (unfold square, inner; ring). lra. }
  exists s. repeat split; [assumption | | exact lv | exact lx].
  (* At s = 1 the point would be x, to which x is nearest. *)
  assert (s1 : s <= 1) by (apply Rmult_le_reg_r with d; lra).
  destruct (Req_dec s 1) as [one | ne]; [exfalso | lra].
  rewrite one in lx. pose proof (square_positive W (xx - wx) (xy - wy) hw x_is_not_w) as far.
  replace (1 * xx - wx) with (xx - wx) in lx by ring. replace (1 * xy - wy) with (xy - wy) in lx by ring.
  replace (square X (1 * xx - xx) (1 * xy - xy)) with 0 in lx by (unfold square, inner; ring). lra.
Qed.
End edge.

(* The rule of ties.md. Gradients D_i at the common point, and pushes e_i. *)
Definition three ax ay bx by_ cx cy := turn ax ay bx by_ cx cy.
Definition four vx vy ve wx wy we xx xy xe yx yy ye :=
  ye * three vx vy wx wy xx xy - xe * three vx vy wx wy yx yy +
  we * three vx vy xx xy yx yy - ve * three wx wy xx xy yx yy.

(* Where the perturbed squared distances of v, w, x are one number r, that of y is farther by h. *)
Theorem perturbed_height vx vy ve wx wy we xx xy xe yx yy ye deltax deltay r :
  2 * (vx * deltax + vy * deltay) + ve = r -> 2 * (wx * deltax + wy * deltay) + we = r ->
  2 * (xx * deltax + xy * deltay) + xe = r ->
  (2 * (yx * deltax + yy * deltay) + ye - r) * three vx vy wx wy xx xy =
  four vx vy ve wx wy we xx xy xe yx yy ye.
Proof.
  intros hv hw hx.
  assert (ve = r - 2 * (vx * deltax + vy * deltay)) as -> by lra.
  assert (we = r - 2 * (wx * deltax + wy * deltay)) as -> by lra.
  assert (xe = r - 2 * (xx * deltax + xy * deltay)) as -> by lra.
  unfold four, three, turn; ring.
Qed.

(* Whichever of x and y is asked about, the numerator is the same but for its sign: with the two
   denominators of opposite signs the answers agree. *)
Theorem tie_rule_is_symmetric vx vy ve wx wy we xx xy xe yx yy ye :
  four vx vy ve wx wy we yx yy ye xx xy xe = - four vx vy ve wx wy we xx xy xe yx yy ye /\
  four wx wy we vx vy ve xx xy xe yx yy ye = - four vx vy ve wx wy we xx xy xe yx yy ye /\
  four xx xy xe yx yy ye vx vy ve wx wy we = four vx vy ve wx wy we xx xy xe yx yy ye.
Proof. unfold four, three, turn; repeat split; ring. Qed.

(* Pushes e, e^2, e^3, e^4 from the greatest site down: the first whose factor is not zero decides. *)
Theorem greatest_site_decides c1 c2 c3 c4 :
  c1 <> 0 -> exists small, 0 < small /\ forall e, 0 < e < small ->
    0 < c1 * (c1 * e + c2 * e ^ 2 + c3 * e ^ 3 + c4 * e ^ 4).
Proof.
  intro h. set (b := Rabs c2 + Rabs c3 + Rabs c4).
  assert (hb : 0 <= b) by (unfold b; pose proof (Rabs_pos c2); pose proof (Rabs_pos c3); pose proof (Rabs_pos c4); lra).
  assert (h1 : 0 < Rabs c1) by (apply Rabs_pos_lt; assumption).
  exists (Rmin 1 (Rabs c1 / (b + 1))). split; [apply Rmin_pos; [lra | apply Rdiv_lt_0_compat; lra] | ].
  intros e [pe se].
  assert (e1 : e < 1) by (apply Rlt_le_trans with (1 := se), Rmin_l).
  assert (eb : e * (b + 1) < Rabs c1).
  { assert (small : e < Rabs c1 / (b + 1)) by (apply Rlt_le_trans with (1 := se), Rmin_r).
    apply Rmult_lt_compat_r with (r := b + 1) in small; [ | lra].
    replace (Rabs c1 / (b + 1) * (b + 1)) with (Rabs c1) in small by (field; lra). exact small. }
  set (rest := c2 + c3 * e + c4 * e ^ 2).
  assert (bound : Rabs rest <= b).
  { unfold rest, b. pose proof (Rabs_triang (c2 + c3 * e) (c4 * e ^ 2)) as t1.
    pose proof (Rabs_triang c2 (c3 * e)) as t2. rewrite Rabs_mult in t1, t2.
    rewrite (Rabs_pos_eq e) in t2 by lra. rewrite (Rabs_pos_eq (e ^ 2)) in t1 by (apply pow_le; lra).
    pose proof (Rabs_pos c3); pose proof (Rabs_pos c4).
    assert (Rabs c3 * e <= Rabs c3 * 1) by (apply Rmult_le_compat_l; lra).
    assert (Rabs c4 * e ^ 2 <= Rabs c4 * 1) by (apply Rmult_le_compat_l; [lra | simpl; nra]). lra. }
  replace (c1 * (c1 * e + c2 * e ^ 2 + c3 * e ^ 3 + c4 * e ^ 4)) with (e * (c1 * c1 + c1 * (e * rest)))
    by (unfold rest; ring).
  apply Rmult_lt_0_compat; [assumption | ].
  assert (square_of : c1 * c1 = Rabs c1 * Rabs c1)
    by (unfold Rabs; destruct (Rcase_abs c1); ring).
  assert (lower : - (Rabs c1 * (e * b)) <= c1 * (e * rest)).
  { assert (Rabs (c1 * (e * rest)) <= Rabs c1 * (e * b)).
    { rewrite !Rabs_mult, (Rabs_pos_eq e) by lra.
      apply Rmult_le_compat_l; [lra | ]. apply Rmult_le_compat_l; lra. }
    pose proof (Rle_abs (- (c1 * (e * rest)))) as low. rewrite Rabs_Ropp in low. lra. }
  rewrite square_of. assert (Rabs c1 * (e * b) < Rabs c1 * Rabs c1) by (apply Rmult_lt_compat_l; nra). lra.
Qed.

(* In one metric M the determinants are the turns of the sites, times that of M: gradients M (q - p). *)
Theorem one_metric_turns M vx vy wx wy xx xy qx qy :
  let gx px py := m11 M * (qx - px) + m12 M * (qy - py) in
  let gy px py := m12 M * (qx - px) + m22 M * (qy - py) in
  three (gx vx vy) (gy vx vy) (gx wx wy) (gy wx wy) (gx xx xy) (gy xx xy) =
  determinant M * turn vx vy wx wy xx xy.
Proof. intros gx gy; unfold three, gx, gy, turn, determinant; ring. Qed.
