(* SPDX-License-Identifier: MIT *)
(* Part (1) of the meeting lemma of docs/math/certificate.md, 4.3, with bounds that are concave and
   homogeneous, of which superadditivity is used alone. Statements in words: docs/math/formal.md. *)
Require Import Reals Lra Psatz.
From formal Require Import geometry counting.
Open Scope R_scope.

(* What is in the cone of x and u is seen from v on the side of x. *)
Lemma toward_in_the_cone V xx xy ux uy m n :
  positive_definite V -> xx <> 0 \/ xy <> 0 -> 0 <= m -> 0 <= n -> 0 < m + n -> 0 < inner V ux uy xx xy ->
  0 < inner V (m * xx + n * ux) (m * xy + n * uy) xx xy.
Proof.
  intros hv no hm hn some hu.
  replace (inner V (m * xx + n * ux) (m * xy + n * uy) xx xy)
    with (m * square V xx xy + n * inner V ux uy xx xy) by (unfold square, inner; ring).
  pose proof (square_positive V xx xy hv no) as own.
  assert (0 <= m * square V xx xy) by (apply Rmult_le_pos; lra).
  assert (0 <= n * inner V ux uy xx xy) by (apply Rmult_le_pos; lra).
  destruct (Req_dec m 0) as [zero | nm].
  - assert (0 < n * inner V ux uy xx xy) by (apply Rmult_lt_0_compat; lra). lra.
  - assert (0 < m * square V xx xy) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

(* v is the origin, x a neighbour, u the direction that the page calls u0, p = m x + n u. *)
Section cone.
Variables (V X : metric) (xx xy ux uy px py m n : R).
Hypothesis (hv : positive_definite V) (hx : positive_definite X).
Hypothesis (x_is_not_v : xx <> 0 \/ xy <> 0).
Hypothesis (hm : 0 <= m) (hn : 0 <= n) (some : 0 < m + n).
Hypothesis (epx : px = m * xx + n * ux) (epy : py = m * xy + n * uy).

(* b is a bound from below of what the first meeting with the bisector of v and x is at: in each
   direction q of the cone the bisector is met at q / b q or before. Then what v dominates over x is
   strictly inside the triangle of v, x / b x and u / b u. *)
Theorem meeting_in_the_cone (b : R -> R -> R) :
  0 < inner V ux uy xx xy -> 0 < b xx xy -> 0 < b ux uy ->
  (forall k l, 0 <= k -> 0 <= l ->
     k * b xx xy + l * b ux uy <= b (k * xx + l * ux) (k * xy + l * uy)) ->
  (forall k l qx qy, 0 <= k -> 0 <= l -> qx = k * xx + l * ux -> qy = k * xy + l * uy -> 0 < b qx qy ->
     exists t, 0 < t /\ t * b qx qy <= 1 /\ gap V X xx xy (t * qx) (t * qy) = 0) ->
  dominates V X xx xy px py -> m * b xx xy + n * b ux uy < 1.
Proof.
  intros hu bx bu concave bound dom. apply Rnot_le_lt; intro beyond.
  assert (toward : 0 < inner V px py xx xy).
  { rewrite epx, epy. apply toward_in_the_cone; assumption. }
  pose proof (concave m n hm hn) as more. rewrite <- epx, <- epy in more.
  assert (large : 1 <= b px py) by lra.
  assert (positive : 0 < b px py) by lra.
  destruct (bound m n px py hm hn epx epy positive) as (t & ht & le & meets).
  assert (short : t <= 1).
  { apply Rnot_lt_le; intro long.
    assert (t * 1 <= t * b px py) by (apply Rmult_le_compat_l; lra). lra. }
  exact (first_meeting V X xx xy hv hx x_is_not_v px py t toward (conj ht short) meets dom).
Qed.

(* So p, if v and w are equally far from it, is within r of both: the z of the meeting lemma. *)
Theorem reach_in_the_cone bx bu r :
  0 <= r -> 0 < bx -> 0 < bu -> m * bx + n * bu <= 1 ->
  square V xx xy <= (r * bx) ^ 2 -> square V ux uy <= (r * bu) ^ 2 ->
  square V px py <= r ^ 2.
Proof.
  intros hr hbx hbu inside far_x far_u.
  set (i := inner V xx xy ux uy).
  set (A := r * bx). set (B := r * bu).
  assert (hA : 0 <= A) by (apply Rmult_le_pos; lra).
  assert (hB : 0 <= B) by (apply Rmult_le_pos; lra).
  fold A in far_x; fold B in far_u.
  assert (schwarz : i ^ 2 <= (A * B) ^ 2).
  { assert (e : i ^ 2 = square V xx xy * square V ux uy - determinant V * (xx * uy - xy * ux) ^ 2)
      by (unfold i, square, inner, determinant; ring).
    destruct hv as [h1 det]. pose proof (pow2_ge_0 (xx * uy - xy * ux)) as area.
    assert (0 <= determinant V * (xx * uy - xy * ux) ^ 2) by (apply Rmult_le_pos; lra).
    pose proof (square_not_negative V xx xy hv) as sx. pose proof (square_not_negative V ux uy hv) as su.
    assert (square V xx xy * square V ux uy <= A ^ 2 * B ^ 2)
      by (apply Rmult_le_compat; assumption).
    replace ((A * B) ^ 2) with (A ^ 2 * B ^ 2) by ring. lra. }
  assert (pos : 0 <= A * B) by (apply Rmult_le_pos; assumption).
  assert (mixed : i <= A * B).
  { apply Rnot_lt_le; intro more.
    assert ((A * B) * (A * B) < i * i) by (apply Rmult_le_0_lt_compat; lra). simpl in schwarz. lra. }
  rewrite epx, epy.
  replace (square V (m * xx + n * ux) (m * xy + n * uy))
    with (m ^ 2 * square V xx xy + 2 * (m * n * i) + n ^ 2 * square V ux uy)
    by (unfold i, square, inner; ring).
  assert (mn : 0 <= m * n) by (apply Rmult_le_pos; assumption).
  assert (one : m ^ 2 * square V xx xy <= m ^ 2 * A ^ 2)
    by (apply Rmult_le_compat_l; [apply pow2_ge_0 | assumption]).
  assert (two : n ^ 2 * square V ux uy <= n ^ 2 * B ^ 2)
    by (apply Rmult_le_compat_l; [apply pow2_ge_0 | assumption]).
  assert (three : m * n * i <= m * n * (A * B)) by (apply Rmult_le_compat_l; assumption).
  assert (mb : 0 <= m * bx) by (apply Rmult_le_pos; lra).
  assert (nb : 0 <= n * bu) by (apply Rmult_le_pos; lra).
  set (S := m * bx + n * bu) in *.
  assert (unit : S * S <= 1 * 1) by (apply Rmult_le_compat; unfold S in *; lra).
  assert (whole : m ^ 2 * A ^ 2 + 2 * (m * n * (A * B)) + n ^ 2 * B ^ 2 = r ^ 2 * (S * S))
    by (unfold A, B, S; ring).
  assert (r ^ 2 * (S * S) <= r ^ 2 * 1)
    by (apply Rmult_le_compat_l; [apply pow2_ge_0 | lra]).
  lra.
Qed.
End cone.
