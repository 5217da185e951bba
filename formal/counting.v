(* SPDX-License-Identifier: MIT *)
(* The lemma of 4.1 of docs/math/certificate.md, with its counting, and what the proofs beside meshes
   rest on: docs/math/proof-format.md, theorems 2 and 3. Statements in words: docs/math/formal.md. *)
Require Import Reals Lra Lia Psatz FunctionalExtensionality.
From formal Require Import geometry.
Open Scope R_scope.

(* Where the ray with the coefficients a and b in c and e meets the segment from c to e. *)
Lemma place_on_row a b : 0 <= a -> 0 <= b -> 0 < a + b ->
  0 <= b / (a + b) <= 1 /\ 0 < 1 / (a + b) /\ (1 < a + b -> 1 / (a + b) < 1) /\
  forall c e, 1 / (a + b) * (a * c + b * e) = c + b / (a + b) * (e - c).
Proof.
  intros ha hb some. pose proof (Rinv_0_lt_compat _ some) as positive.
  assert (one : (a + b) * / (a + b) = 1) by (apply Rinv_r; lra).
  unfold Rdiv. repeat split.
  - apply Rmult_le_pos; lra.
  - apply Rmult_le_reg_r with (a + b); [lra | ]. rewrite Rmult_assoc, Rinv_l; lra.
  - lra.
  - intro beyond. apply Rmult_lt_reg_r with (a + b); [lra | ]. rewrite Rmult_assoc, Rinv_l; lra.
  - intros c e. field. lra.
Qed.

(* A quadratic, by its values. *)
Definition quadratic (f : R -> R) := exists a b c, forall t, f t = a * t ^ 2 + b * t + c.
(* It has exactly so many zeros in [0, 1]: 0, 1 or 2. *)
Definition zeros (f : R -> R) (n : nat) : Prop :=
  match n with
  | 0%nat => forall t, 0 <= t <= 1 -> f t <> 0
  | 1%nat => exists r, 0 <= r <= 1 /\ f r = 0 /\ forall t, 0 <= t <= 1 -> f t = 0 -> t = r
  | 2%nat => exists r s, 0 <= r <= 1 /\ 0 <= s <= 1 /\ r <> s /\ f r = 0 /\ f s = 0 /\
      forall t, 0 <= t <= 1 -> f t = 0 -> t = r \/ t = s
  | _ => False
  end.

Lemma zeros_none f n : zeros f n -> (forall t, 0 <= t <= 1 -> f t <> 0) -> n = 0%nat.
Proof.
  destruct n as [ | [ | [ | n]]]; simpl; intros h k; try tauto.
  - destruct h as (r & hr & fr & _); destruct (k r hr fr).
  - destruct h as (r & s & hr & _ & _ & fr & _); destruct (k r hr fr).
Qed.

Lemma zeros_some f n r : zeros f n -> 0 <= r <= 1 -> f r = 0 -> n <> 0%nat.
Proof. intros h hr fr e; subst; exact (h r hr fr). Qed.

Lemma zeros_at_most_2 f n : zeros f n -> (n <= 2)%nat.
Proof. destruct n as [ | [ | [ | n]]]; simpl; intros; try lia; tauto. Qed.

Lemma zeros_one f n r :
  zeros f n -> 0 <= r <= 1 -> f r = 0 -> (forall t, 0 <= t <= 1 -> f t = 0 -> t = r) -> n = 1%nat.
Proof.
  destruct n as [ | [ | [ | n]]]; simpl; intros h hr fr only; try tauto; try reflexivity.
  - destruct (h r hr fr).
  - destruct h as (p & q & hp & hq & ne & fp & fq & _).
    rewrite (only p hp fp), (only q hq fq) in ne; tauto.
Qed.

Lemma zeros_two f n r s :
  zeros f n -> 0 <= r <= 1 -> 0 <= s <= 1 -> r <> s -> f r = 0 -> f s = 0 -> n = 2%nat.
Proof.
  destruct n as [ | [ | [ | n]]]; simpl; intros h hr hs ne fr fs; try tauto; try reflexivity.
  - destruct (h r hr fr).
  - destruct h as (p & _ & _ & only). rewrite (only r hr fr), (only s hs fs) in ne; tauto.
Qed.

(* A quadratic with opposite signs at the ends has one zero between them. *)
Lemma one_zero_between a b c r t :
  0 < c -> a + b + c < 0 -> 0 <= r <= 1 -> 0 <= t <= 1 ->
  a * r ^ 2 + b * r + c = 0 -> a * t ^ 2 + b * t + c = 0 -> t = r.
Proof.
  intros hc h1 hr ht er et.
  destruct (Req_dec t r) as [ | ne]; [assumption | exfalso].
  (* a (t + r) + b = 0, so a t r = c and the value at 1 is a (1 - t) (1 - r). *)
  assert (s : a * (t + r) + b = 0).
  { apply Rmult_eq_reg_l with (t - r); [ | lra].
    replace ((t - r) * (a * (t + r) + b)) with
      ((a * t ^ 2 + b * t + c) - (a * r ^ 2 + b * r + c)) by ring. lra. }
  assert (p : a * (t * r) = c).
  { replace b with (- (a * (t + r))) in er by lra. simpl in er. lra. }
  assert (v : a + b + c = a * ((1 - t) * (1 - r))).
  { replace b with (- (a * (t + r))) by lra. rewrite <- p; ring. }
  assert (0 <= t * r) by (apply Rmult_le_pos; lra).
  assert (0 <= (1 - t) * (1 - r)) by (apply Rmult_le_pos; lra).
  destruct (Rle_or_lt a 0); nra.
Qed.

(* Points of the segment from v, the origin, to p, and from z = d to p. *)
Section first_meeting.
Variables (V Z : metric) (dx dy : R).
Hypothesis (hv : positive_definite V) (hz : positive_definite Z) (hd : dx <> 0 \/ dy <> 0).
Variables (px py : R).

Definition from_v t := gap V Z dx dy (t * px) (t * py).
Definition from_z t := along V Z dx dy px py t.
(* v dominates p over z (definition 6): its segment meets the bisector more seldom. *)
Definition dominates := exists m n, zeros from_v m /\ zeros from_z n /\ (m < n)%nat.

Lemma at_v : from_v 0 < 0.
Proof.
  unfold from_v, gap. pose proof (square_positive Z (- dx) (- dy) hz) as h.
  replace (0 * px - dx) with (- dx) by ring; replace (0 * py - dy) with (- dy) by ring.
  unfold square at 1, inner. assert (0 < square Z (- dx) (- dy)) by (apply h; lra). lra.
Qed.

Lemma at_z : 0 < from_z 0.
Proof.
  unfold from_z, along, gap. pose proof (square_positive V dx dy hv hd).
  replace (dx + 0 * (px - dx)) with dx by ring; replace (dy + 0 * (py - dy)) with dy by ring.
  unfold square at 2, inner. replace (dx - dx) with 0 by ring; replace (dy - dy) with 0 by ring. lra.
Qed.

Lemma at_p : from_v 1 = gap V Z dx dy px py /\ from_z 1 = gap V Z dx dy px py.
Proof. unfold from_v, from_z, along; split; f_equal; ring. Qed.

Lemma from_v_quadratic : quadratic from_v.
Proof.
  exists (square V px py - square Z px py), (2 * inner Z px py dx dy), (- square Z dx dy).
  intro t; unfold from_v, gap, square, inner; ring.
Qed.

Lemma from_z_quadratic : quadratic from_z.
Proof.
  set (ex := px - dx); set (ey := py - dy).
  exists (square V ex ey - square Z ex ey), (2 * inner V dx dy ex ey), (square V dx dy).
  intro t; unfold from_z, along, gap, square, inner; fold ex ey; ring.
Qed.

(* A point of the bisector that z sees by L(p) > 0 is the only one on its segment. *)
Lemma seen_point_is_alone r :
  0 < sees V dx dy px py -> gap V Z dx dy px py = 0 -> 0 <= r <= 1 -> from_z r = 0 -> r = 1.
Proof.
  intros hp on hr fr. pose proof at_z as start. destruct at_p as [_ ez].
  destruct (Req_dec r 1) as [ | r1]; [assumption | exfalso].
  assert (r0 : 0 < r) by (destruct (Req_dec r 0) as [-> | ]; lra).
  destruct (along_is_quadratic V Z dx dy px py 1 r) as (slope & bend & at1 & _ & falls).
  fold from_z in *. change (along V Z dx dy px py) with from_z in *.
  rewrite fr, ez, on in at1. rewrite fr in falls.
  destruct (along_is_quadratic V Z dx dy px py r 1) as (slope' & bend' & atr & shape & falls').
  change (along V Z dx dy px py) with from_z in *. rewrite ez, on in *. rewrite fr in atr.
  replace (dx + 1 * (px - dx)) with px in falls' by ring.
  replace (dy + 1 * (py - dy)) with py in falls' by ring.
  assert (s1 : slope' < 0) by lra.
  assert (seen : 0 < sees V dx dy (dx + r * (px - dx)) (dy + r * (py - dy))).
  { replace (sees V dx dy (dx + r * (px - dx)) (dy + r * (py - dy)))
      with ((1 - r) * sees V dx dy dx dy + r * sees V dx dy px py) by (unfold sees, inner; ring).
    pose proof (square_positive V dx dy hv hd) as hs. unfold square in hs. unfold sees at 1.
    assert (0 < (1 - r) * inner V dx dy dx dy) by (apply Rmult_lt_0_compat; lra).
    assert (0 < r * sees V dx dy px py) by (apply Rmult_lt_0_compat; lra). lra. }
  assert (s2 : slope < 0).
  { assert (0 < - (r * slope)) by lra. apply Rnot_le_lt; intro no.
    assert (0 <= r * slope) by (apply Rmult_le_pos; lra). lra. }
  (* Both slopes of one quadratic with zeros at r and 1: they are opposite. *)
  assert (e1 : slope = - (bend * (1 - r))).
  { apply Rmult_eq_reg_r with (1 - r); [simpl in at1; lra | lra]. }
  assert (e2 : slope' = - (bend' * (r - 1))).
  { apply Rmult_eq_reg_r with (r - 1); [simpl in atr; lra | lra]. }
  assert (b1 : 0 < bend).
  { apply Rnot_le_lt; intro no. assert (0 <= - bend * (1 - r)) by (apply Rmult_le_pos; lra). lra. }
  assert (b2 : bend' < 0).
  { apply Rnot_le_lt; intro no. assert (0 <= bend' * (1 - r)) by (apply Rmult_le_pos; lra). lra. }
  pose proof (shape 0) as z0. rewrite e2 in z0. simpl in z0.
  assert (from_z 0 = bend' * r) by lra.
  assert (bend' * r < 0) by nra. lra.
Qed.

(* The lemma of 4.1: where the ray of v, within a right angle of z, has met their bisector, v
   dominates no point from there on. *)
Theorem first_meeting t0 :
  0 < sees V dx dy px py -> 0 < t0 <= 1 -> from_v t0 = 0 -> ~ dominates.
Proof.
  intros hp ht root (m & n & hm & hn & less).
  assert (m0 : m <> 0%nat) by (apply (zeros_some from_v m t0); [assumption | lra | assumption]).
  assert (n2 : (n <= 2)%nat) by exact (zeros_at_most_2 _ _ hn).
  assert (m1 : m = 1%nat) by lia. assert (en : n = 2%nat) by lia. subst m n. clear less m0 n2.
  destruct at_p as [ev ez]. pose proof at_z as start. pose proof at_v as begin.
  destruct (Rtotal_order (gap V Z dx dy px py) 0) as [below | [on | above]].
  - (* p is nearer to v: from z the difference falls from positive to negative, once. *)
    destruct hn as (r & s & hr & hs & ne & fr & fs & _).
    destruct from_z_quadratic as (a & b & c & shape).
    apply ne, (one_zero_between a b c s r).
    + rewrite shape in start; simpl in start; lra.
    + rewrite <- ez in below; rewrite shape in below; simpl in below; lra.
    + assumption.
    + assumption.
    + rewrite <- shape; assumption.
    + rewrite <- shape; assumption.
  - (* p is on the bisector: z sees it, and so meets it there alone. *)
    assert (two : exists r, 0 < r < 1 /\ from_z r = 0).
    { destruct hn as (r & s & hr & hs & ne & fr & fs & _).
      destruct (Req_dec r 1) as [-> | r1].
      - exists s; split; [ | assumption]. destruct (Req_dec s 0) as [-> | ]; lra.
      - exists r; split; [ | assumption]. destruct (Req_dec r 0) as [-> | ]; lra. }
    destruct two as (r & hr & fr).
    pose proof (seen_point_is_alone r hp on (conj (Rlt_le _ _ (proj1 hr)) (Rlt_le _ _ (proj2 hr))) fr). lra.
  - (* p is nearer to z, which sees it without meeting the bisector. *)
    destruct hn as (r & _ & hr & _ & _ & fr & _).
    exact (nearer_point_is_seen V Z dx dy hv hd px py hp above r hr fr).
Qed.
End first_meeting.

(* A continuous function that changes its sign has a zero. *)
Lemma quadratic_continuous f : quadratic f -> continuity f.
Proof.
  intros (a & b & c & shape).
  replace f with (fun t => a * (t * t) + b * t + c)
    by (apply functional_extensionality; intro t; rewrite shape; ring).
  reg.
Qed.

Lemma sign_stays f s t :
  quadratic f -> 0 <= s <= 1 -> 0 <= t <= 1 -> 0 < f s -> (forall r, 0 <= r <= 1 -> f r <> 0) -> 0 < f t.
Proof.
  intros q hs ht fs no. pose proof (quadratic_continuous f q) as cont.
  apply Rnot_le_lt; intro ft.
  destruct (Rle_or_lt s t) as [le | lt].
  - destruct (IVT_cor f s t cont le) as (r & hr & fr); [nra | apply (no r); [lra | assumption]].
  - destruct (IVT_cor f t s cont (Rlt_le _ _ lt)) as (r & hr & fr);
      [nra | apply (no r); [lra | assumption]].
Qed.

(* Four sites, seen from v at the origin: v, w and a neighbour x, each with its metric. *)
Section gap_between_neighbours.
Variables (V W X : metric) (wx wy xx xy px py : R).
Hypothesis (hv : positive_definite V) (hw : positive_definite W) (hx : positive_definite X).
Hypothesis (w_is_not_v : wx <> 0 \/ wy <> 0) (x_is_not_v : xx <> 0 \/ xy <> 0).
Hypothesis (x_is_not_w : xx - wx <> 0 \/ xy - wy <> 0).

Definition f_v qx qy := square V qx qy.
Definition f_w qx qy := square W (qx - wx) (qy - wy).
Definition f_x qx qy := square X (qx - xx) (qy - xy).
(* Definition 6, of v and of w: for w the origin is moved there. *)
Definition v_dominates := dominates V X xx xy px py.
Definition w_dominates := dominates W X (xx - wx) (xy - wy) (px - wx) (py - wy).

Lemma v_difference qx qy : gap V X xx xy qx qy = f_v qx qy - f_x qx qy.
Proof. reflexivity. Qed.
Lemma w_difference qx qy :
  gap W X (xx - wx) (xy - wy) (qx - wx) (qy - wy) = f_w qx qy - f_x qx qy.
Proof. unfold gap, f_w, f_x, square, inner; ring. Qed.

(* v dominates p, within a right angle of x: then p is nearer to v, by the lemma of 4.1. *)
Lemma dominated_point_is_nearer :
  0 < inner V px py xx xy -> v_dominates -> f_v px py < f_x px py.
Proof.
  intros hp dom. pose proof (at_v V X xx xy hx x_is_not_v px py) as start.
  destruct (at_p V X xx xy px py) as [ev _]. rewrite v_difference in ev.
  apply Rnot_le_lt; intro no.
  pose proof (quadratic_continuous _ (from_v_quadratic V X xx xy px py)) as cont.
  destruct (IVT_cor _ 0 1 cont ltac:(lra)) as (t & ht & root); [nra | ].
  assert (t <> 0) by (intro; subst; lra).
  exact (first_meeting V X xx xy hv hx x_is_not_v px py t hp ltac:(lra) root dom).
Qed.

(* Theorem 3 of proof-format.md, (ii): x strictly between w and p as seen from v, and outside of their
   triangle. Then w is nearer than v and x to the point z in which x's ray leaves it. *)
Theorem point_of_the_edge a b :
  f_v px py = f_w px py -> 0 < inner V px py wx wy -> v_dominates -> w_dominates ->
  0 < a -> 0 < b -> xx = a * wx + b * px -> xy = a * wy + b * py -> 1 < a + b ->
  exists s, 0 < s < 1 /\ s * (a + b) = 1 /\ let zx := s * xx in let zy := s * xy in
    f_w zx zy < f_v zx zy /\ f_w zx zy < f_x zx zy.
Proof.
  intros on seen dv dw ha hb ex ey outside.
  assert (p_is_not_v : 0 <= square V px py) by exact (square_not_negative V px py hv).
  assert (toward_x : 0 < inner V px py xx xy).
  { rewrite ex, ey. replace (inner V px py (a * wx + b * px) (a * wy + b * py))
      with (a * inner V px py wx wy + b * square V px py) by (unfold square, inner; ring).
    assert (0 < a * inner V px py wx wy) by (apply Rmult_lt_0_compat; assumption).
    assert (0 <= b * square V px py) by (apply Rmult_le_pos; lra). lra. }
  pose proof (dominated_point_is_nearer toward_x dv) as near.
  set (t := b / (a + b)).
  assert (ht : 0 < t < 1).
  { unfold t; split; [apply Rdiv_lt_0_compat; lra | ].
    apply Rmult_lt_reg_r with (a + b); [lra | ]. unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra. }
  assert (place : forall d q, (a * d + b * q) * (1 / (a + b)) = d + t * (q - d))
    by (intros; unfold t; field; lra).
  exists (1 / (a + b)). split.
  { split; [apply Rdiv_lt_0_compat; lra | ].
    apply Rmult_lt_reg_r with (a + b); [lra | ]. unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra. }
  split; [field; lra | ].
  cbv zeta.
  assert (zx : 1 / (a + b) * xx = wx + t * (px - wx)) by (rewrite ex, <- place; ring).
  assert (zy : 1 / (a + b) * xy = wy + t * (py - wy)) by (rewrite ey, <- place; ring).
  rewrite zx, zy.
  split.
  - (* w sees p: before p it is nearer. *)
    pose proof (at_z V W wx wy hv w_is_not_v px py) as start.
    assert (0 < from_z V W wx wy px py t); [ | unfold from_z, along, gap in *; unfold f_w, f_v; lra].
    apply Rnot_le_lt; intro no.
    pose proof (quadratic_continuous _ (from_z_quadratic V W wx wy px py)) as cont.
    destruct (IVT_cor _ 0 t cont ltac:(lra)) as (r & hr & root); [nra | ].
    assert (on' : gap V W wx wy px py = 0) by (unfold gap; unfold f_v, f_w in on; lra).
    pose proof (seen_point_is_alone V W wx wy hv w_is_not_v px py r seen on' ltac:(lra) root). lra.
  - (* Along x-p one zero, so along w-p none. *)
    destruct dw as (m & n & hm & hn & less).
    set (dx := xx - wx) in *; set (dy := xy - wy) in *.
    set (qx := px - wx) in *; set (qy := py - wy) in *.
    destruct (at_p W X dx dy qx qy) as [ev ez].
    assert (diff : gap W X dx dy qx qy < 0).
    { unfold dx, dy, qx, qy; rewrite w_difference. lra. }
    pose proof (at_z W X dx dy hw x_is_not_w qx qy) as start.
    pose proof (quadratic_continuous _ (from_z_quadratic W X dx dy qx qy)) as cont.
    destruct (IVT_cor _ 0 1 cont ltac:(lra)) as (r & hr & root); [nra | ].
    assert (n = 1%nat).
    { apply (zeros_one _ n r hn hr root). intros s hs fs.
      destruct (from_z_quadratic W X dx dy qx qy) as (c2 & c1 & c0 & shape).
      apply (one_zero_between c2 c1 c0 r s); try assumption.
      - rewrite shape in start; simpl in start; lra.
      - rewrite <- ez in diff; rewrite shape in diff; simpl in diff; lra.
      - rewrite <- shape; assumption.
      - rewrite <- shape; assumption. }
    assert (m = 0%nat) by lia. subst m n. simpl in hm.
    assert (away : from_v W X dx dy qx qy t < 0).
    { apply Ropp_lt_cancel; rewrite Ropp_0.
      apply (sign_stays (fun t => - from_v W X dx dy qx qy t) 0 t); try lra.
      - destruct (from_v_quadratic W X dx dy qx qy) as (c2 & c1 & c0 & shape).
        exists (- c2), (- c1), (- c0); intro; rewrite shape; ring.
      - pose proof (at_v W X dx dy hx x_is_not_w qx qy); lra.
      - intros s hs; pose proof (hm s hs); lra. }
    unfold from_v in away.
    replace (t * qx) with (wx + t * qx - wx) in away by ring.
    replace (t * qy) with (wy + t * qy - wy) in away by ring.
    unfold dx, dy in away; rewrite w_difference in away. lra.
Qed.

(* Lemma 2 of proof-format.md: a segment from c to e behind x bounds where v can dominate. *)
Theorem row_bounds_the_region cx cy ex ey a b :
  0 < inner V cx cy xx xy -> 0 < inner V ex ey xx xy ->
  (forall t, 0 <= t <= 1 ->
     f_x (cx + t * (ex - cx)) (cy + t * (ey - cy)) <= f_v (cx + t * (ex - cx)) (cy + t * (ey - cy))) ->
  0 <= a -> 0 <= b -> 0 < a + b -> px = a * cx + b * ex -> py = a * cy + b * ey ->
  v_dominates -> a + b <= 1.
Proof.
  intros hc he behind ha hb some epx epy dom. apply Rnot_lt_le; intro beyond.
  assert (toward : 0 < inner V px py xx xy).
  { rewrite epx, epy. replace (inner V (a * cx + b * ex) (a * cy + b * ey) xx xy)
      with (a * inner V cx cy xx xy + b * inner V ex ey xx xy) by (unfold inner; ring).
    destruct (Req_dec a 0) as [-> | na]; [nra | ]. nra. }
  destruct (place_on_row a b ha hb some) as (ht & positive & less & place).
  set (s := 1 / (a + b)) in *. set (t := b / (a + b)) in *. specialize (less beyond).
  pose proof (behind t ht) as at_row. rewrite <- !place, <- epx, <- epy in at_row.
  pose proof (at_v V X xx xy hx x_is_not_v px py) as start.
  pose proof (quadratic_continuous _ (from_v_quadratic V X xx xy px py)) as cont.
  assert (there : 0 <= from_v V X xx xy px py s)
    by (unfold from_v; rewrite v_difference; lra).
  destruct (IVT_cor _ 0 s cont ltac:(lra)) as (r & hr & root); [nra | ].
  assert (r <> 0) by (intro; subst; lra).
  exact (first_meeting V X xx xy hv hx x_is_not_v px py r toward ltac:(lra) root dom).
Qed.

(* Theorem 2 of proof-format.md, of one neighbour: what is nearer to v than to x all the way is
   dominated by v. *)
Theorem nearer_all_the_way_dominates :
  (forall t, 0 <= t <= 1 -> f_v (t * px) (t * py) < f_x (t * px) (t * py)) -> v_dominates.
Proof.
  intro near. exists 0%nat, 1%nat. repeat split; [ | | lia].
  - intros t ht; unfold from_v; rewrite v_difference. pose proof (near t ht); lra.
  - pose proof (at_z V X xx xy hv x_is_not_v px py) as start.
    destruct (at_p V X xx xy px py) as [_ ez]. rewrite v_difference in ez.
    pose proof (near 1 ltac:(lra)) as end_. rewrite !Rmult_1_l in end_.
    pose proof (quadratic_continuous _ (from_z_quadratic V X xx xy px py)) as cont.
    destruct (IVT_cor _ 0 1 cont ltac:(lra)) as (r & hr & root); [nra | ].
    exists r; repeat split; try lra. intros s hs fs.
    destruct (from_z_quadratic V X xx xy px py) as (c2 & c1 & c0 & shape).
    apply (one_zero_between c2 c1 c0 r s); try assumption.
    + rewrite shape in start; simpl in start; lra.
    + rewrite shape in ez; simpl in ez; lra.
    + rewrite <- shape; assumption.
    + rewrite <- shape; assumption.
Qed.
End gap_between_neighbours.
