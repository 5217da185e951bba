(* SPDX-License-Identifier: MIT *)
(* Lemmas of docs/math/certificate.md over the reals. Statements in words: docs/math/formal.md. *)
Require Import Reals Lra Psatz.
Open Scope R_scope.

(* Orientation. *)
Definition turn (px py qx qy rx ry : R) : R := (qx - px) * (ry - py) - (qy - py) * (rx - px).

Theorem orientation_cyclic px py qx qy rx ry :
  turn px py qx qy rx ry = turn qx qy rx ry px py.
Proof. unfold turn; ring. Qed.

Theorem orientation_exchange px py qx qy rx ry :
  turn px py qx qy rx ry = - turn qx qy px py rx ry.
Proof. unfold turn; ring. Qed.

(* Whichever point the differences are taken from, the determinant is the same number. *)
Theorem orientation_any_first px py qx qy rx ry :
  turn px py qx qy rx ry = turn qx qy rx ry px py /\
  turn px py qx qy rx ry = turn rx ry px py qx qy.
Proof. unfold turn; split; ring. Qed.

Theorem orientation_affine a b c d tx ty px py qx qy rx ry :
  0 < a * d - b * c ->
  let X x y := a * x + b * y + tx in
  let Y x y := c * x + d * y + ty in
  let image := turn (X px py) (Y px py) (X qx qy) (Y qx qy) (X rx ry) (Y rx ry) in
  image = (a * d - b * c) * turn px py qx qy rx ry /\
  (0 < image <-> 0 < turn px py qx qy rx ry) /\ (image = 0 <-> turn px py qx qy rx ry = 0).
Proof.
  intros h X Y image.
  assert (e : image = (a * d - b * c) * turn px py qx qy rx ry)
    by (unfold image, X, Y, turn; ring).
  rewrite e; set (t := turn px py qx qy rx ry); repeat split; intro k; try nra.
Qed.

(* Metrics: M = (a, b; b, c), positive definite. *)
Record metric := { m11 : R; m12 : R; m22 : R }.
Definition determinant M := m11 M * m22 M - m12 M * m12 M.
Definition positive_definite M := 0 < m11 M /\ 0 < determinant M.
Definition inner M ux uy wx wy :=
  m11 M * ux * wx + m12 M * (ux * wy + uy * wx) + m22 M * uy * wy.
Definition square M ux uy := inner M ux uy ux uy.

Lemma square_positive M ux uy : positive_definite M -> ux <> 0 \/ uy <> 0 -> 0 < square M ux uy.
Proof.
  unfold positive_definite, determinant, square, inner; destruct M as [a b c]; simpl.
  intros [ha hd] hu.
  assert (e : a * (a * ux * ux + b * (ux * uy + uy * ux) + c * uy * uy) =
              (a * ux + b * uy) * (a * ux + b * uy) + (a * c - b * b) * (uy * uy)) by ring.
  assert (0 < a * (a * ux * ux + b * (ux * uy + uy * ux) + c * uy * uy)).
  { rewrite e. destruct (Req_dec uy 0) as [z | n].
    - subst; destruct hu as [h | h]; [ | lra].
      assert (0 < (a * ux) * (a * ux)) by (apply Rsqr_pos_lt; apply Rmult_integral_contrapositive_currified; lra).
      nra.
    - assert (0 < uy * uy) by (apply Rsqr_pos_lt; assumption).
      assert (0 < (a * c - b * b) * (uy * uy)) by (apply Rmult_lt_0_compat; lra).
      assert (0 <= (a * ux + b * uy) * (a * ux + b * uy)) by apply Rle_0_sqr.
      lra. }
  apply Rmult_lt_reg_l with a; lra.
Qed.

Lemma square_not_negative M ux uy : positive_definite M -> 0 <= square M ux uy.
Proof.
  intro h; destruct (Req_dec ux 0) as [x | x], (Req_dec uy 0) as [y | y];
    try (left; apply square_positive; tauto).
  subst; unfold square, inner; right; ring.
Qed.

(* A bisector is met along a ray from v, the origin, in the roots of a quadratic, and a point q of
   it is seen by z, not as a tangent, where L(q) = q^T M_v d > 0: seen from z, the difference of the
   two squared distances falls there. *)
Section first_meeting.
Variables (V Z : metric) (dx dy : R).   (* M_v, M_z, d = z - v *)
Hypothesis (hv : positive_definite V) (hz : positive_definite Z) (hd : dx <> 0 \/ dy <> 0).

Definition gap qx qy := square V qx qy - square Z (qx - dx) (qy - dy).      (* f_v - f_z *)
Definition sees qx qy := inner V qx qy dx dy.                                (* L *)

(* The equation C s^2 - 2 H s - A = 0 of s = 1 / t. *)
Theorem meeting_equation ux uy s :
  s <> 0 ->
  (gap (ux / s) (uy / s) = 0 <->
   square Z dx dy * s ^ 2 - 2 * inner Z ux uy dx dy * s - (square V ux uy - square Z ux uy) = 0).
Proof.
  intro h. unfold gap.
  assert (e : (square V (ux / s) (uy / s) - square Z (ux / s - dx) (uy / s - dy)) * s ^ 2 =
    - (square Z dx dy * s ^ 2 - 2 * inner Z ux uy dx dy * s - (square V ux uy - square Z ux uy)))
    by (unfold square, inner; field; assumption).
  assert (0 < s ^ 2) by (assert (0 < s * s) by (apply Rsqr_pos_lt; assumption); simpl; lra).
  split; intro k; nra.
Qed.

(* The identity under the root: M_z - (M_z d)(M_z d)^T / C = (det M_z / C) (Jd)(Jd)^T. *)
Theorem meeting_root ux uy :
  square Z dx dy * square Z ux uy - inner Z ux uy dx dy ^ 2 =
  determinant Z * (ux * dy - uy * dx) ^ 2.
Proof. unfold square, inner, determinant; ring. Qed.

(* Along the segment from z to p, in the parameter t. *)
Definition along px py t := gap (dx + t * (px - dx)) (dy + t * (py - dy)).

Lemma along_is_quadratic px py t t0 :
  exists slope bend,
    along px py t = along px py t0 + slope * (t - t0) + bend * (t - t0) ^ 2 /\
    (forall r, along px py r = along px py t0 + slope * (r - t0) + bend * (r - t0) ^ 2) /\
    t0 * slope = 2 * along px py t0 - 2 * sees (dx + t0 * (px - dx)) (dy + t0 * (py - dy)).
Proof.
  set (ex := px - dx); set (ey := py - dy).
  exists (2 * inner V (dx + t0 * ex) (dy + t0 * ey) ex ey - 2 * t0 * square Z ex ey).
  exists (square V ex ey - square Z ex ey).
  unfold along, gap, sees, square, inner; fold ex ey; repeat split; intros; ring.
Qed.

Lemma no_second_root f (k : forall t0, exists slope bend,
    (forall r, f r = f t0 + slope * (r - t0) + bend * (r - t0) ^ 2) /\
    (0 < t0 < 1 -> f t0 = 0 -> slope < 0)) :
  0 < f 1 -> forall t, 0 < t < 1 -> f t <> 0.
Proof.
  intros f1 t ht root.
  destruct (k t) as (slope & bend & shape & falls).
  specialize (falls ht root). rewrite root in shape.
  pose proof (shape 1) as at1. 
  assert (bend_positive : 0 < bend) by (assert (0 < (1 - t) ^ 2) by nra; nra).
  set (r := t - slope / bend).
  assert (er : bend * (r - t) = - slope) by (unfold r; field; lra).
  assert (r_above : t < r).
  { apply Rnot_le_lt; intro no.
    assert (0 <= bend * (t - r)) by (apply Rmult_le_pos; lra). lra. }
  assert (at_end : 0 < (slope + bend * (1 - t)) * (1 - t)) by (simpl in at1; lra).
  assert (rise : 0 < slope + bend * (1 - t)).
  { apply Rmult_lt_reg_r with (1 - t); lra. }
  assert (r_below : r < 1).
  { apply Rnot_le_lt; intro no.
    assert (0 <= bend * (r - 1)) by (apply Rmult_le_pos; lra). lra. }
  assert (root_r : f r = 0).
  { rewrite shape. replace (0 + slope * (r - t) + bend * (r - t) ^ 2)
      with ((r - t) * (slope + bend * (r - t))) by ring. rewrite er; ring. }
  destruct (k r) as (slope' & bend' & shape' & falls').
  specialize (falls' (conj (Rlt_trans _ _ _ (proj1 ht) r_above) r_below) root_r).
  (* The slope at r, from the shape at t: the opposite of that at t. *)
  assert (same : forall q, 0 + slope' * (q - r) + bend' * (q - r) ^ 2 =
                           0 + slope * (q - t) + bend * (q - t) ^ 2)
    by (intro q; rewrite <- shape, shape', root_r; reflexivity).
  pose proof (same (r + 1)) as s1. pose proof (same (r - 1)) as s2.
  assert (slope' = slope + 2 * (bend * (r - t))) by (simpl in s1, s2; lra).
  lra.
Qed.

(* The heart of the lemma of 4.1: a point p with L(p) > 0 that is nearer to z is seen by z without
   meeting the bisector at all. *)
Theorem nearer_point_is_seen px py :
  0 < sees px py -> 0 < gap px py -> forall t, 0 <= t <= 1 -> along px py t <> 0.
Proof.
  intros hp near t ht.
  assert (start : 0 < along px py 0).
  { unfold along, gap. replace (dx + 0 * (px - dx)) with dx by ring.
    replace (dy + 0 * (py - dy)) with dy by ring.
    pose proof (square_positive V dx dy hv hd). unfold square at 2, inner. 
    replace (dx - dx) with 0 by ring. replace (dy - dy) with 0 by ring. lra. }
  assert (finish : along px py 1 = gap px py)
    by (unfold along; f_equal; ring).
  assert (hs : 0 < sees dx dy) by (unfold sees; exact (square_positive V dx dy hv hd)).
  destruct (Req_dec t 0) as [-> | n0]; [lra | ].
  destruct (Req_dec t 1) as [-> | n1]; [lra | ].
  apply no_second_root; [ | lra | lra].
  intro t0; destruct (along_is_quadratic px py 0 t0) as (slope & bend & _ & shape & slopes).
  exists slope, bend; split; [exact shape | ].
  intros h0 root; rewrite root in slopes.
  assert (0 < sees (dx + t0 * (px - dx)) (dy + t0 * (py - dy))).
  { replace (sees (dx + t0 * (px - dx)) (dy + t0 * (py - dy)))
      with ((1 - t0) * sees dx dy + t0 * sees px py) by (unfold sees, inner; ring). nra. }
  nra.
Qed.

End first_meeting.

(* Covectors: |g|_M^2 = g M^-1 g^T, and g.q <= |g|_M |q|_M. *)
Definition covector_square M gx gy :=
  (m22 M * gx * gx - 2 * m12 M * gx * gy + m11 M * gy * gy) / determinant M.

Theorem covector_bounds M gx gy qx qy :
  positive_definite M ->
  gx * qx + gy * qy <= sqrt (covector_square M gx gy) * sqrt (square M qx qy).
Proof.
  intros h; pose proof h as [ha hd].
  assert (e : covector_square M gx gy * square M qx qy =
    (gx * qx + gy * qy) ^ 2 +
    ((m11 M * qx + m12 M * qy) * gy - (m12 M * qx + m22 M * qy) * gx) ^ 2 / determinant M)
    by (unfold covector_square, square, inner; unfold determinant in *; field; lra).
  assert (p : 0 <= covector_square M gx gy).
  { unfold covector_square, Rdiv. apply Rmult_le_pos; [ | left; apply Rinv_0_lt_compat; lra].
    pose proof (square_not_negative M gy (- gx) h) as k. unfold square, inner in k. lra. }
  rewrite <- sqrt_mult_alt by assumption.
  destruct (Rle_dec 0 (gx * qx + gy * qy)) as [g | g].
  - rewrite <- (sqrt_pow2 (gx * qx + gy * qy)) by assumption.
    apply sqrt_le_1_alt. rewrite e.
    assert (0 <= ((m11 M * qx + m12 M * qy) * gy - (m12 M * qx + m22 M * qy) * gx) ^ 2 /
                 determinant M).
    { unfold Rdiv; apply Rmult_le_pos; [apply pow2_ge_0 | left; apply Rinv_0_lt_compat; lra]. }
    lra.
  - pose proof (sqrt_pos (covector_square M gx gy * square M qx qy)); lra.
Qed.

(* The largest value of a G_v X + G_w min(a X, (1 - a) Y). *)
Lemma edge_bound a gv gw X Y R0 :
  0 <= a <= 1 -> 0 <= gv -> 0 <= gw -> 0 < X -> 0 < Y -> X * Y <= R0 * (X + Y) -> X <= 2 * R0 ->
  a * gv * X + gw * Rmin (a * X) ((1 - a) * Y) <= (gv + Rmax gv gw) * R0.
Proof.
  intros ha hgv hgw hx hy kink far.
  pose proof (Rmax_l gv gw); pose proof (Rmax_r gv gw).
  set (G := Rmax gv gw) in *.
  set (m := Rmin (a * X) ((1 - a) * Y)).
  assert (m <= a * X) by apply Rmin_l. assert (m <= (1 - a) * Y) by apply Rmin_r.
  assert (0 <= m) by (apply Rmin_glb; nra).
  assert (m <= R0). 
  { assert (m * (X + Y) <= X * Y) by nra. nra. }
  assert (gw * m <= G * m) by nra.
  (* with r = R0: a X + m <= 2 R0, since beyond the kink the sum grows no further than its ends *)
  destruct (Rle_dec (a * X) R0) as [near | beyond].
  - assert (gv * (a * X) <= gv * R0) by nra. assert (G * m <= G * R0) by nra. nra.
  - assert (s : a * X + m <= 2 * R0).
    { assert (m + a * X <= a * X + (1 - a) * Y) by lra.
      destruct (Rle_dec X Y) as [xy | yx]; [ | nra].
      assert (X * Y < X * (a * (X + Y))) by nra.
      assert (Y < a * (X + Y)) by (apply Rmult_lt_reg_l with X; assumption).
      assert ((a * X + (1 - a) * Y) * (X + Y) <= 2 * (X * Y)) by nra.
      assert (a * X + (1 - a) * Y <= 2 * R0) by (apply Rmult_le_reg_r with (X + Y); lra).
      lra. }
    assert (gv * (a * X) + G * m <= gv * R0 + G * R0).
    { assert (gv * (a * X - R0) <= G * (a * X - R0)) by nra. nra. }
    nra.
Qed.

(* What the meeting lemma says of an accepted w: a point z, seen from v at the origin. x is the
   neighbour on whose edge z may be. *)
Definition meets V W X wx wy xx xy R0 zx zy : Prop :=
  let lv := sqrt (square V zx zy) in
  let lw := sqrt (square W (wx - zx) (wy - zy)) in
  let Lv := sqrt (square V xx xy) in
  let Lx := sqrt (square X xx xy) in
  (lw <= R0 /\ lv <= R0) \/
  (exists a, 0 <= a <= 1 /\ zx = a * xx /\ zy = a * xy /\
     lw <= Rmin (a * Lv) ((1 - a) * Lx) /\ Lv * Lx <= R0 * (Lv + Lx) /\ Lv <= 2 * R0).

(* The covector lemma: beyond its bound no point as in the meeting lemma exists. *)
Theorem covector_lemma V W X gx gy wx wy xx xy R0 :
  positive_definite V -> positive_definite W -> positive_definite X -> xx <> 0 \/ xy <> 0 ->
  let gv := sqrt (covector_square V gx gy) in
  let gw := sqrt (covector_square W gx gy) in
  (gv + Rmax gv gw) * R0 < gx * wx + gy * wy ->
  forall zx zy, ~ meets V W X wx wy xx xy R0 zx zy.
Proof.
  intros hv hw hx hn gv gw far zx zy meet.
  assert (0 <= gv) by apply sqrt_pos. assert (0 <= gw) by apply sqrt_pos.
  pose proof (covector_bounds V gx gy zx zy hv) as bv.
  pose proof (covector_bounds W gx gy (wx - zx) (wy - zy) hw) as bw.
  fold gv in bv; fold gw in bw. unfold meets in meet.
  set (lv := sqrt (square V zx zy)) in *.
  set (lw := sqrt (square W (wx - zx) (wy - zy))) in *.
  pose proof (Rmax_l gv gw); pose proof (Rmax_r gv gw).
  destruct meet as [[near_w near_v] | (a & ha & ez & ey & near & kink & twice)].
  - assert (0 <= lw) by apply sqrt_pos.
    assert (gw * lw <= gw * R0) by (apply Rmult_le_compat_l; assumption).
    assert (gv * lv <= gv * R0) by (apply Rmult_le_compat_l; assumption).
    assert (gw * R0 <= Rmax gv gw * R0) by (apply Rmult_le_compat_r; lra).
    lra.
  - set (Lv := sqrt (square V xx xy)) in *; set (Lx := sqrt (square X xx xy)) in *.
    assert (0 < Lv) by (apply sqrt_lt_R0, square_positive; assumption).
    assert (0 < Lx) by (apply sqrt_lt_R0, square_positive; assumption).
    pose proof (edge_bound a gv gw Lv Lx R0 ha ltac:(assumption) ltac:(assumption)
                  ltac:(assumption) ltac:(assumption) kink twice) as top.
    pose proof (covector_bounds V gx gy xx xy hv) as bx; fold gv Lv in bx.
    assert (gw * lw <= gw * Rmin (a * Lv) ((1 - a) * Lx)) by (apply Rmult_le_compat_l; assumption).
    assert (a * (gx * xx + gy * xy) <= a * (gv * Lv)) by (apply Rmult_le_compat_l; lra).
    subst zx zy. lra.
Qed.
