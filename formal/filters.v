(* SPDX-License-Identifier: MIT *)
(* The constants of kernels/semi_static_filter.hpp: its formulas, and that the sign each decides is
   the exact one. Statements in words: docs/math/formal.md. *)
Require Import Reals Lra Lia Psatz.
From formal Require Import rounding.
Open Scope R_scope.

(* Whatever a machine makes of the value e and the magnitude s: where |e| exceeds the bound
   k (d + 8) eps s + 2^-200, as computed, the sign of e is right. *)
Definition decides (e s : expression) (k : R) (d : nat) : Prop :=
  forall z w b c, computes e z -> computes s w ->
    rounds (k * ((INR d + 8) * eps) * w) b -> rounds (b + tiny) c -> c < Rabs z -> 0 < z * exact e.

(* Positive definite, as far as it is used. *)
Definition definite a b c := 0 <= a /\ 0 <= c /\ b * b <= a * c.

Lemma absolute_square x : Rabs x * Rabs x = x * x.
Proof. rewrite <- Rabs_mult; apply Rabs_right, Rle_ge, Rle_0_sqr. Qed.

Lemma mixed_mean a b c : definite a b c -> Rabs b <= a + c.
Proof.
  intros (ha & hc & hd). apply Rabs_le; split; nra.
Qed.

Lemma mixed_product a b c x y :
  definite a b c -> 2 * (Rabs b * (Rabs x * Rabs y)) <= a * (x * x) + c * (y * y).
Proof.
  intros (ha & hc & hd).
  rewrite <- (Rabs_mult x y), <- Rabs_mult.
  apply Rsqr_incr_0_var; [ | nra]. unfold Rsqr.
  assert (e : Rabs (b * (x * y)) * Rabs (b * (x * y)) = (b * b) * ((x * x) * (y * y)))
    by (rewrite absolute_square; ring).
  assert (0 <= (x * x) * (y * y)) by (apply Rmult_le_pos; apply Rle_0_sqr).
  assert ((b * b) * ((x * x) * (y * y)) <= (a * c) * ((x * x) * (y * y)))
    by (apply Rmult_le_compat_r; assumption).
  pose proof (Rle_0_sqr (a * (x * x) - c * (y * y))) as p. unfold Rsqr in p.
  lra.
Qed.

Ltac bound_absolute_error :=
  cbn -[pow eps eta harmless]; cbn [pow]; unfold eps, eta, harmless; lra.

Ltac decide_by k :=
  intros ? ? ? ?; apply (sign_is_decided _ _ k); try (cbn; lia); try lra;
  [cbn; tauto | cbn; tauto | bound_absolute_error | bound_absolute_error | | ].

Definition cross ax ay bx by_ := difference (product ax by_) (product ay bx).

(* Orientation: depth 4, half of the sum of squares. *)
Theorem orientation_constant px py qx qy rx ry :
  let ax := offset px qx in let ay := offset py qy in
  let bx := offset px rx in let by_ := offset py ry in
  in_range ax -> in_range ay -> in_range bx -> in_range by_ ->
  decides (cross ax ay bx by_)
    (sum (sum (product ax ax) (product bx bx)) (sum (product ay ay) (product by_ by_))) (1 / 2) 4.
Proof.
  cbn -[decides pow]; intros h1 h2 h3 h4. decide_by (1 / 2).
  - cbn -[pow]. set (ex := qx - px); set (fx := rx - px); set (ey := qy - py); set (fy := ry - py).
    rewrite !absolute_square. reflexivity.
  - cbn -[pow]. set (ex := qx - px); set (fx := rx - px); set (ey := qy - py); set (fy := ry - py).
    pose proof (Rle_0_sqr (Rabs ex - Rabs fy)); pose proof (Rle_0_sqr (Rabs ey - Rabs fx)).
    unfold Rsqr in *. lra.
Qed.

Definition unmixed a c ux uy :=
  sum (product (given a) (product ux ux)) (product (given c) (product uy uy)).
Definition squared_length a b c ux uy :=
  let mixed := product (given b) (product ux uy) in
  sum (unmixed a c ux uy) (sum mixed mixed).

Lemma unmixed_exact a b c ux uy :
  definite a b c -> exact ux * exact ux = magnitude ux * magnitude ux ->
  exact uy * exact uy = magnitude uy * magnitude uy ->
  exact (unmixed a c ux uy) = magnitude (unmixed a c ux uy).
Proof.
  intros (ha & hc & _) hx hy; cbn. rewrite !(Rabs_right a), !(Rabs_right c), hx, hy by lra.
  reflexivity.
Qed.

Lemma offset_square p q :
  exact (offset p q) * exact (offset p q) = magnitude (offset p q) * magnitude (offset p q).
Proof. cbn; rewrite absolute_square; reflexivity. Qed.

Lemma squared_length_magnitude a b c p q r s :
  definite a b c ->
  magnitude (squared_length a b c (offset p q) (offset r s)) <=
  2 * magnitude (unmixed a c (offset p q) (offset r s)).
Proof.
  intro h; pose proof (mixed_product a b c (q - p) (s - r) h) as m.
  destruct h as (ha & hc & _). cbn. rewrite !(Rabs_right a), !(Rabs_right c) by lra.
  rewrite !absolute_square. lra.
Qed.

(* Comparison of two squared distances, each in its own metric: depth 7, twice the unmixed terms. *)
Theorem compare_distance_constant a b c a' b' c' vx vy wx wy qx qy :
  definite a b c -> definite a' b' c' ->
  let ux := offset vx qx in let uy := offset vy qy in
  let tx := offset wx qx in let ty := offset wy qy in
  in_range (squared_length a b c ux uy) -> in_range (squared_length a' b' c' tx ty) ->
  decides (difference (squared_length a b c ux uy) (squared_length a' b' c' tx ty))
    (sum (unmixed a c ux uy) (unmixed a' c' tx ty)) 2 7.
Proof.
  intros h h' ux uy tx ty r r'. 
  cbn -[decides pow] in r, r'. decide_by 2.
  - cbn [exact magnitude]. f_equal; eapply unmixed_exact; eauto using offset_square.
  - pose proof (squared_length_magnitude a b c vx qx vy qy h).
    pose proof (squared_length_magnitude a' b' c' wx qx wy qy h').
    change (magnitude (squared_length a b c ux uy) + magnitude (squared_length a' b' c' tx ty) <=
      2 * (magnitude (unmixed a c ux uy) + magnitude (unmixed a' c' tx ty))).
    unfold ux, uy, tx, ty; lra.
Qed.

Definition inner_product a b c ux uy dx dy :=
  sum (product ux (sum (product (given a) dx) (product (given b) dy)))
      (product uy (sum (product (given b) dx) (product (given c) dy))).
Definition extent ux uy := sum (absolute ux) (absolute uy).
Definition product_of_extents a c ux uy dx dy :=
  product (extent ux uy) (product (extent dx dy) (sum (given a) (given c))).

Lemma inner_product_magnitude a b c ux uy dx dy :
  definite a b c ->
  magnitude (inner_product a b c ux uy dx dy) <= magnitude (product_of_extents a c ux uy dx dy).
Proof.
  intro h; pose proof (mixed_mean a b c h) as m; destruct h as (ha & hc & _).
  cbn. rewrite (Rabs_right a), (Rabs_right c) by lra.
  pose proof (magnitude_not_negative ux); pose proof (magnitude_not_negative uy).
  pose proof (magnitude_not_negative dx); pose proof (magnitude_not_negative dy).
  set (X := magnitude ux) in *; set (Y := magnitude uy) in *.
  set (D := magnitude dx) in *; set (E := magnitude dy) in *. pose proof (Rabs_pos b).
  assert (a * D + Rabs b * E <= (D + E) * (a + c)) by nra.
  assert (Rabs b * D + c * E <= (D + E) * (a + c)) by nra.
  assert (X * (a * D + Rabs b * E) <= X * ((D + E) * (a + c))) by (apply Rmult_le_compat_l; lra).
  assert (Y * (Rabs b * D + c * E) <= Y * ((D + E) * (a + c))) by (apply Rmult_le_compat_l; lra).
  lra.
Qed.

(* One of the two values of in_wedge: depth 6, the product of the extents. *)
Theorem in_wedge_constant a b c vx vy wx wy qx qy :
  definite a b c ->
  let ux := offset vx qx in let uy := offset vy qy in
  let dx := offset vx wx in let dy := offset vy wy in
  in_range (inner_product a b c ux uy dx dy) ->
  decides (inner_product a b c ux uy dx dy) (product_of_extents a c ux uy dx dy) 1 6.
Proof.
  intros h ux uy dx dy r. cbn -[decides pow] in r. decide_by 1.
  - destruct h as (ha & hc & _); cbn. rewrite (Rabs_right a), (Rabs_right c) by lra. reflexivity.
  - rewrite Rmult_1_l; apply inner_product_magnitude; assumption.
Qed.

(* The first condition of dominates, A + C > 0: the squared length of u in the nearer metric, less
   that in the farther one, and with that of d there. Depth 8, twice the unmixed terms. *)
Theorem steepness_of_lengths_constant a b c a' b' c' vx vy wx wy px py :
  definite a b c -> definite a' b' c' ->
  let ux := offset vx px in let uy := offset vy py in
  let dx := offset vx wx in let dy := offset vy wy in
  in_range (squared_length a b c ux uy) -> in_range (squared_length a' b' c' ux uy) ->
  in_range (squared_length a' b' c' dx dy) ->
  decides
    (sum (difference (squared_length a b c ux uy) (squared_length a' b' c' ux uy))
         (squared_length a' b' c' dx dy))
    (sum (unmixed a c ux uy) (sum (unmixed a' c' ux uy) (unmixed a' c' dx dy))) 2 8.
Proof.
  intros h h' ux uy dx dy r r' rd.
  cbn -[decides pow] in r, r', rd. decide_by 2.
  - cbn [exact magnitude]. f_equal; [ | f_equal]; eapply unmixed_exact; eauto using offset_square.
  - pose proof (squared_length_magnitude a b c vx px vy py h).
    pose proof (squared_length_magnitude a' b' c' vx px vy py h').
    pose proof (squared_length_magnitude a' b' c' vx wx vy wy h').
    cbn [magnitude]. unfold ux, uy, dx, dy; lra.
Qed.

(* The third, A + H > 0, H the product of u and d in the farther metric. The second, H < 0, is one
   of the two values of in_wedge. Depth 8, twice the unmixed terms and the product of the extents;
   twice is a sum with itself. *)
Theorem steepness_of_product_constant a b c a' b' c' vx vy wx wy px py :
  definite a b c -> definite a' b' c' ->
  let ux := offset vx px in let uy := offset vy py in
  let dx := offset vx wx in let dy := offset vy wy in
  in_range (squared_length a b c ux uy) -> in_range (squared_length a' b' c' ux uy) ->
  in_range (inner_product a' b' c' ux uy dx dy) ->
  decides
    (sum (difference (squared_length a b c ux uy) (squared_length a' b' c' ux uy))
         (inner_product a' b' c' ux uy dx dy))
    (let unmixed_terms := sum (unmixed a c ux uy) (unmixed a' c' ux uy) in
     sum (sum unmixed_terms unmixed_terms) (product_of_extents a' c' ux uy dx dy)) 1 8.
Proof.
  intros h h' ux uy dx dy r r' rh.
  cbn -[decides pow] in r, r', rh. decide_by 1.
  - assert (exact (unmixed a c ux uy) = magnitude (unmixed a c ux uy)) as e
      by (eapply unmixed_exact; eauto; unfold ux, uy; apply offset_square).
    assert (exact (unmixed a' c' ux uy) = magnitude (unmixed a' c' ux uy)) as e'
      by (eapply unmixed_exact; eauto; unfold ux, uy; apply offset_square).
    assert (exact (product_of_extents a' c' ux uy dx dy) =
            magnitude (product_of_extents a' c' ux uy dx dy)) as ep.
    { destruct h' as (ha & hc & _); cbn. rewrite (Rabs_right a'), (Rabs_right c') by lra.
      reflexivity. }
    cbn [exact magnitude]. rewrite e, e', ep. reflexivity.
  - pose proof (squared_length_magnitude a b c vx px vy py h).
    pose proof (squared_length_magnitude a' b' c' vx px vy py h').
    pose proof (inner_product_magnitude a' b' c' ux uy dx dy h').
    cbn [magnitude]. unfold ux, uy, dx, dy in *; lra.
Qed.

(* The determinant that is_positive_definite asks about: depth 2, its own two terms. *)
Theorem positive_definite_constant a b c :
  in_range (given a) -> in_range (given b) -> in_range (given c) ->
  decides (difference (product (given a) (given c)) (product (given b) (given b)))
    (sum (absolute (product (given a) (given c))) (product (given b) (given b))) 1 2.
Proof.
  intros ra rb rc. cbn -[decides pow] in ra, rb, rc. decide_by 1.
  - cbn. rewrite absolute_square, Rabs_mult. reflexivity.
  - cbn. lra.
Qed.

Definition half_of_terms ax ay bx by_ :=
  half (sum (absolute (product ax by_)) (absolute (product ay bx))).

Lemma area_magnitude ax ay bx by_ :
  magnitude (cross ax ay bx by_) = 2 * magnitude (half_of_terms ax ay bx by_).
Proof. cbn; field. Qed.

Lemma half_of_terms_exact p q r s t u v w :
  exact (half_of_terms (offset p q) (offset r s) (offset t u) (offset v w)) =
  magnitude (half_of_terms (offset p q) (offset r s) (offset t u) (offset v w)).
Proof. cbn. rewrite !Rabs_mult. reflexivity. Qed.

Lemma product_of_bounds L H A h :
  0 <= H -> 0 <= h -> 0 <= L <= 2 * H -> A = 2 * h -> L * A <= 4 * (H * h).
Proof. intros; subst; nra. Qed.

(* The usual in-circle test of a constant metric: depth 13, four times the unmixed halves. *)
Theorem in_circle_constant a b c px py qx qy rx ry sx sy :
  definite a b c ->
  let ux := offset sx px in let uy := offset sy py in
  let vx := offset sx qx in let vy := offset sy qy in
  let wx := offset sx rx in let wy := offset sy ry in
  in_range (given a) -> in_range (given b) -> in_range (given c) ->
  in_range ux -> in_range uy -> in_range vx -> in_range vy -> in_range wx -> in_range wy ->
  decides
    (sum (sum (product (squared_length a b c ux uy) (cross vx vy wx wy))
              (product (squared_length a b c vx vy) (cross wx wy ux uy)))
         (product (squared_length a b c wx wy) (cross ux uy vx vy)))
    (sum (sum (product (unmixed a c ux uy) (half_of_terms vx vy wx wy))
              (product (unmixed a c vx vy) (half_of_terms wx wy ux uy)))
         (product (unmixed a c wx wy) (half_of_terms ux uy vx vy))) 4 13.
Proof.
  intros h ux uy vx vy wx wy ra rb rc hux huy hvx hvy hwx hwy.
  cbn -[decides pow] in ra, rb, rc, hux, huy, hvx, hvy, hwx, hwy.
  intros ? ? ? ?; apply (sign_is_decided _ _ 4); try (cbn; lia); try lra.
  - cbn; tauto.
  - cbn; tauto.
  - bound_absolute_error.
  - bound_absolute_error.
  - cbn [exact magnitude].
    unfold ux, uy, vx, vy, wx, wy.
    rewrite !half_of_terms_exact.
    rewrite !(unmixed_exact a b c) by (auto using offset_square). reflexivity.
  - cbn [magnitude].
    assert (forall p q r s, magnitude (squared_length a b c (offset p q) (offset r s)) <=
              2 * magnitude (unmixed a c (offset p q) (offset r s)))
      as lengths by (intros; apply squared_length_magnitude; assumption).
    unfold ux, uy, vx, vy, wx, wy.
    rewrite !area_magnitude.
    pose proof (product_of_bounds _ _ _ _ (magnitude_not_negative (unmixed a c (offset sx px) (offset sy py)))
      (magnitude_not_negative (half_of_terms (offset sx qx) (offset sy qy) (offset sx rx) (offset sy ry)))
      (conj (magnitude_not_negative _) (lengths sx px sy py)) eq_refl).
    pose proof (product_of_bounds _ _ _ _ (magnitude_not_negative (unmixed a c (offset sx qx) (offset sy qy)))
      (magnitude_not_negative (half_of_terms (offset sx rx) (offset sy ry) (offset sx px) (offset sy py)))
      (conj (magnitude_not_negative _) (lengths sx qx sy qy)) eq_refl).
    pose proof (product_of_bounds _ _ _ _ (magnitude_not_negative (unmixed a c (offset sx rx) (offset sy ry)))
      (magnitude_not_negative (half_of_terms (offset sx px) (offset sy py) (offset sx qx) (offset sy qy)))
      (conj (magnitude_not_negative _) (lengths sx rx sy ry)) eq_refl).
    lra.
Qed.

Definition sum_of_terms ax ay bx by_ := sum (absolute (product ax by_)) (absolute (product ay bx)).

Lemma sum_of_terms_exact p q r s t u v w :
  exact (sum_of_terms (offset p q) (offset r s) (offset t u) (offset v w)) =
  magnitude (sum_of_terms (offset p q) (offset r s) (offset t u) (offset v w)).
Proof. cbn. rewrite !Rabs_mult. reflexivity. Qed.

Lemma product_of_extents_exact a b c p q r s t u v w :
  definite a b c ->
  exact (product_of_extents a c (offset p q) (offset r s) (offset t u) (offset v w)) =
  magnitude (product_of_extents a c (offset p q) (offset r s) (offset t u) (offset v w)).
Proof.
  intros (ha & hc & _); cbn. rewrite (Rabs_right a), (Rabs_right c) by lra. reflexivity.
Qed.

(* The edge test among equal metrics: opposite angles, by cotangent and area: depth 12. *)
Theorem edge_test_constant a b c vx vy wx wy xx xy yx yy :
  definite a b c ->
  let dx := offset vx wx in let dy := offset vy wy in
  let px := offset vx xx in let py := offset vy xy in
  let qx := offset wx xx in let qy := offset wy xy in
  let rx := offset vx yx in let ry := offset vy yy in
  let sx := offset wx yx in let sy := offset wy yy in
  in_range (given a) -> in_range (given b) -> in_range (given c) ->
  in_range dx -> in_range dy -> in_range px -> in_range py -> in_range qx -> in_range qy ->
  in_range rx -> in_range ry -> in_range sx -> in_range sy ->
  decides
    (sum (product (inner_product a b c px py qx qy) (absolute (cross dx dy rx ry)))
         (product (inner_product a b c rx ry sx sy) (absolute (cross dx dy px py))))
    (sum (product (product_of_extents a c px py qx qy) (sum_of_terms dx dy rx ry))
         (product (product_of_extents a c rx ry sx sy) (sum_of_terms dx dy px py))) 1 12.
Proof.
  intros h dx dy px py qx qy rx ry sx sy ra rb rc h1 h2 h3 h4 h5 h6 h7 h8 h9 h10.
  cbn -[decides pow] in ra, rb, rc, h1, h2, h3, h4, h5, h6, h7, h8, h9, h10.
  intros ? ? ? ?; apply (sign_is_decided _ _ 1); try (cbn; lia); try lra.
  - cbn; tauto.
  - cbn; tauto.
  - bound_absolute_error.
  - bound_absolute_error.
  - cbn [exact magnitude]. unfold dx, dy, px, py, qx, qy, rx, ry, sx, sy.
    rewrite !sum_of_terms_exact, !(product_of_extents_exact a b c) by assumption. reflexivity.
  - cbn [magnitude]. rewrite Rmult_1_l.
    apply Rplus_le_compat; (apply Rmult_le_compat;
      [apply magnitude_not_negative | cbn; apply Rplus_le_le_0_compat; apply Rmult_le_pos; apply Rabs_pos |
       apply inner_product_magnitude; assumption | apply Rle_refl]).
Qed.
