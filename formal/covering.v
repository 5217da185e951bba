(* SPDX-License-Identifier: MIT *)
(* Points 1 and 2 of docs/math/certificate.md: triangles cover a point as often as their boundary winds
   around it, wherever the point is, on edges and in vertices too. Statements in words: docs/math/formal.md. *)
Require Import Reals Lra Lia Psatz ZArith List Permutation FinFun.
From formal Require Import geometry.
Import ListNotations.
Open Scope R_scope.

(* The ray from q to the right. An edge from a up to b is crossed by it if q is on its left. The lower
   end belongs to an edge, the upper one does not, and a point on the edge is not on its left. *)
Definition crossed_upward xa ya xb yb xq yq : Z :=
  if Rle_dec ya yq then
    if Rlt_dec yq yb then if Rlt_dec 0 (turn xa ya xb yb xq yq) then 1%Z else 0%Z else 0%Z
  else 0%Z.
Definition crossed xa ya xb yb xq yq : Z :=
  (crossed_upward xa ya xb yb xq yq - crossed_upward xb yb xa ya xq yq)%Z.

Section one_triangle.
Variables xa ya xb yb xc yc xq yq : R.
Let ab := turn xa ya xb yb xq yq.
Let bc := turn xb yb xc yc xq yq.
Let ca := turn xc yc xa ya xq yq.
Hypothesis ccw : 0 < turn xa ya xb yb xc yc.

Definition owned : Z :=
  (crossed xa ya xb yb xq yq + crossed xb yb xc yc xq yq + crossed xc yc xa ya xq yq)%Z.

Lemma three_parts : ab + bc + ca = turn xa ya xb yb xc yc.
Proof. unfold ab, bc, ca, turn; ring. Qed.
Lemma heights : bc * (ya - yq) + ca * (yb - yq) + ab * (yc - yq) = 0.
Proof. unfold ab, bc, ca, turn; ring. Qed.
Lemma beside_b : (yb - yc) * ab + (yb - ya) * bc = (yb - yq) * turn xa ya xb yb xc yc.
Proof. unfold ab, bc, turn; ring. Qed.
Lemma beside_c : (yc - ya) * bc + (yc - yb) * ca = (yc - yq) * turn xa ya xb yb xc yc.
Proof. unfold bc, ca, turn; ring. Qed.
Lemma beside_a : (ya - yb) * ca + (ya - yc) * ab = (ya - yq) * turn xa ya xb yb xc yc.
Proof. unfold ca, ab, turn; ring. Qed.

Lemma reversed_edges :
  turn xb yb xa ya xq yq = - ab /\ turn xc yc xb yb xq yq = - bc /\ turn xa ya xc yc xq yq = - ca.
Proof. unfold ab, bc, ca, turn; repeat split; ring. Qed.

Lemma same_height : ya = yq -> yb = yq -> yc = yq -> turn xa ya xb yb xc yc = 0.
Proof. intros; subst; unfold turn; ring. Qed.

(* Takes apart where the corners are, above q or not, and on which sides of the edges q is. *)
Ltac by_cases :=
  unfold owned, crossed, crossed_upward;
  destruct reversed_edges as (-> & -> & ->); fold ab bc ca;
  pose proof three_parts; pose proof heights; pose proof beside_a; pose proof beside_b; pose proof beside_c;
  set (area := turn xa ya xb yb xc yc) in *;
  destruct (Rle_dec ya yq), (Rle_dec yb yq), (Rle_dec yc yq), (Rlt_dec yq ya), (Rlt_dec yq yb), (Rlt_dec yq yc);
  try lra;
  repeat match goal with |- context [Rlt_dec 0 ?x] => destruct (Rlt_dec 0 x) end.

Theorem owned_or_not : owned = 0%Z \/ owned = 1%Z.
Proof. by_cases; simpl; try (left; reflexivity); try (right; reflexivity); exfalso; nra. Qed.

Theorem inside_is_owned : 0 < ab -> 0 < bc -> 0 < ca -> owned = 1%Z.
Proof.
  pose proof same_height as flat. intros pab pbc pca.
  by_cases; simpl; try reflexivity; exfalso; nra.
Qed.

Theorem owned_is_inside : owned = 1%Z -> 0 <= ab /\ 0 <= bc /\ 0 <= ca.
Proof.
  by_cases; simpl; intro is; try discriminate; repeat split; nra.
Qed.
End one_triangle.

(* A mesh: triangles and directed boundary edges by numbers of vertices, and where these are. *)
Definition triangle := (nat * nat * nat)%type.
Definition edge := (nat * nat)%type.
Definition reverse (e : edge) : edge := (snd e, fst e).
Definition edges_of (t : triangle) : list edge :=
  match t with (a, b, c) => [(a, b); (b, c); (c, a)] end.

Fixpoint total {A : Type} (f : A -> Z) (l : list A) : Z :=
  match l with [] => 0%Z | a :: rest => (f a + total f rest)%Z end.

Lemma total_app A (f : A -> Z) k l : total f (k ++ l) = (total f k + total f l)%Z.
Proof. induction k; simpl; lia. Qed.
Lemma total_permutation A (f : A -> Z) k l : Permutation k l -> total f k = total f l.
Proof. induction 1; simpl; lia. Qed.
Lemma total_map A B (f : B -> Z) (g : A -> B) l : total f (map g l) = total (fun a => f (g a)) l.
Proof. induction l; simpl; lia. Qed.
Lemma total_opposite A (f g : A -> Z) l : (forall a, f a = (- g a)%Z) -> total f l = (- total g l)%Z.
Proof. intro h; induction l as [ | a l IH]; simpl; [ | rewrite h, IH]; lia. Qed.
Lemma total_filter A (f : A -> Z) g l :
  total f l = (total f (filter g l) + total f (filter (fun a => negb (g a)) l))%Z.
Proof. induction l as [ | a l]; simpl; [ | destruct (g a); simpl]; lia. Qed.

Lemma edge_decidable (e f : edge) : {e = f} + {e <> f}.
Proof. decide equality; apply PeanoNat.Nat.eq_dec. Qed.
Lemma reverse_twice e : reverse (reverse e) = e.
Proof. destruct e; reflexivity. Qed.

(* Edges and their reverses cancel: of edges that are listed once there remain those without reverse. *)
Lemma edges_cancel (f : edge -> Z) (all boundary : list edge) :
  (forall e, f (reverse e) = (- f e)%Z) -> NoDup all -> NoDup boundary ->
  (forall e, In e boundary <-> In e all /\ ~ In (reverse e) all) ->
  total f all = total f boundary.
Proof.
  intros odd once once_too left.
  set (paired := fun e => if in_dec edge_decidable (reverse e) all then true else false).
  assert (is : forall e, paired e = true <-> In (reverse e) all)
    by (intro e; unfold paired; destruct (in_dec edge_decidable (reverse e) all); split; intro; congruence || tauto).
  rewrite (total_filter _ f paired all).
  assert (zero : total f (filter paired all) = 0%Z).
  { assert (same : total f (filter paired all) = total f (map reverse (filter paired all))).
    { apply total_permutation, NoDup_Permutation.
      - apply NoDup_filter; assumption.
      - apply Injective_map_NoDup; [ | apply NoDup_filter; assumption].
        intros e e' h; rewrite <- (reverse_twice e), h, reverse_twice; reflexivity.
      - intro e; rewrite in_map_iff; split.
        + intro h; apply filter_In in h; destruct h as [h k]. exists (reverse e).
          split; [apply reverse_twice | ]. apply filter_In; split; [apply is; assumption | ].
          apply is; rewrite reverse_twice; assumption.
        + intros (e' & eq & h); apply filter_In in h; destruct h as [h k]; subst e.
          apply filter_In; split; [apply is; assumption | ].
          apply is; rewrite reverse_twice; assumption. }
    rewrite total_map, (total_opposite _ (fun e => f (reverse e)) f _ odd) in same. lia. }
  rewrite zero, Z.add_0_l. apply total_permutation, NoDup_Permutation.
  - apply NoDup_filter; assumption.
  - assumption.
  - intro e; rewrite filter_In, left, <- is. destruct (paired e); simpl; intuition congruence.
Qed.

Section mesh.
Variables (x y : nat -> R) (triangles : list triangle) (boundary : list edge).
(* Certificate 1, 2 (a) and (b). *)
Hypothesis ccw : forall a b c, In (a, b, c) triangles -> 0 < turn (x a) (y a) (x b) (y b) (x c) (y c).
Hypothesis each_edge_once : NoDup (flat_map edges_of triangles).
Hypothesis each_segment_once : NoDup boundary.
Hypothesis boundary_is_without_reverse : forall e,
  In e boundary <->
  In e (flat_map edges_of triangles) /\ ~ In (reverse e) (flat_map edges_of triangles).
Variables xq yq : R.

Definition crossing (e : edge) : Z :=
  crossed (x (fst e)) (y (fst e)) (x (snd e)) (y (snd e)) xq yq.
Definition winding : Z := total crossing boundary.
Definition owns (t : triangle) : Z :=
  match t with (a, b, c) => owned (x a) (y a) (x b) (y b) (x c) (y c) xq yq end.
Definition is_owner (t : triangle) : bool := Z.eqb (owns t) 1.
Definition strictly_inside (t : triangle) : Prop :=
  match t with (a, b, c) =>
    0 < turn (x a) (y a) (x b) (y b) xq yq /\ 0 < turn (x b) (y b) (x c) (y c) xq yq /\
    0 < turn (x c) (y c) (x a) (y a) xq yq
  end.
Definition inside_or_on (t : triangle) : Prop :=
  match t with (a, b, c) =>
    0 <= turn (x a) (y a) (x b) (y b) xq yq /\ 0 <= turn (x b) (y b) (x c) (y c) xq yq /\
    0 <= turn (x c) (y c) (x a) (y a) xq yq
  end.

Lemma total_of_owners : total owns triangles = total crossing (flat_map edges_of triangles).
Proof.
  clear. induction triangles as [ | [[a b] c] l IH]; [reflexivity | ].
  simpl flat_map. cbn [total app]. rewrite <- IH. unfold owns, owned, crossing; simpl; lia.
Qed.

(* N = W, for every point: also on edges, and where vertices are. *)
Theorem owned_as_often_as_wound : Z.of_nat (length (filter is_owner triangles)) = winding.
Proof.
  assert (count : Z.of_nat (length (filter is_owner triangles)) = total owns triangles).
  { assert (each : forall t, In t triangles -> owns t = 0%Z \/ owns t = 1%Z).
    { intros [[a b] c] h; apply owned_or_not, ccw; assumption. }
    clear - each. induction triangles as [ | t l IH]; [reflexivity | ].
    assert (rest : Z.of_nat (length (filter is_owner l)) = total owns l)
      by (apply IH; intros; apply each; right; assumption).
    cbn [filter total]. unfold is_owner at 1.
    destruct (each t (or_introl eq_refl)) as [-> | ->]; cbn [Z.eqb]; simpl length; lia. }
  rewrite count, total_of_owners. unfold winding.
  apply edges_cancel; try assumption.
  intro e; unfold crossing, crossed, reverse; simpl; lia.
Qed.

Lemma inside_is_owner t : In t triangles -> strictly_inside t -> is_owner t = true.
Proof.
  destruct t as [[a b] c]; intros h (p & q & r). unfold is_owner, owns.
  rewrite (inside_is_owned _ _ _ _ _ _ _ _ (ccw _ _ _ h) p q r); reflexivity.
Qed.

Lemma owner_holds t : In t triangles -> is_owner t = true -> inside_or_on t.
Proof.
  destruct t as [[a b] c]; intros h is. apply Z.eqb_eq in is.
  exact (owned_is_inside _ _ _ _ _ _ _ _ is).
Qed.

(* Where the boundary winds once, one triangle owns the point, and it is in no other's interior. *)
Theorem wound_once_is_in_one :
  winding = 1%Z ->
  exists t, In t triangles /\ inside_or_on t /\ forall s, In s triangles -> strictly_inside s -> s = t.
Proof.
  intro once. pose proof owned_as_often_as_wound as count. rewrite once in count.
  assert (one : length (filter is_owner triangles) = 1%nat) by lia.
  destruct (filter is_owner triangles) as [ | t [ | ]] eqn:list; simpl in one; try discriminate.
  assert (is : In t (filter is_owner triangles)) by (rewrite list; left; reflexivity).
  apply filter_In in is; destruct is as [is own].
  exists t; repeat split; [assumption | apply owner_holds; assumption | ].
  intros s hs inside. assert (again : In s (filter is_owner triangles))
    by (apply filter_In; split; [ | apply inside_is_owner]; assumption).
  rewrite list in again; destruct again as [ | []]; congruence.
Qed.

Theorem wound_never_is_outside :
  winding = 0%Z -> forall t, In t triangles -> ~ strictly_inside t.
Proof.
  intros none t h inside. pose proof owned_as_often_as_wound as count. rewrite none in count.
  assert (is : In t (filter is_owner triangles)) by (apply filter_In; split; [ | apply inside_is_owner]; assumption).
  destruct (filter is_owner triangles); [destruct is | simpl in count; lia].
Qed.
End mesh.

(* Theorem 1 of docs/math/proof-format.md: the boundary is that of a rectangle, corners 0 to 3. *)
Section rectangle.
Variables (x y : nat -> R) (left right low high : R).
Hypothesis (wide : left < right) (tall : low < high).
Hypothesis (corners : x 0%nat = left /\ y 0%nat = low /\ x 1%nat = right /\ y 1%nat = low /\
                      x 2%nat = right /\ y 2%nat = high /\ x 3%nat = left /\ y 3%nat = high).
Definition sides : list edge := [(0, 1); (1, 2); (2, 3); (3, 0)]%nat.

Lemma rectangle_winds_once xq yq :
  left <= xq < right -> low <= yq < high -> winding x y sides xq yq = 1%Z.
Proof.
  destruct corners as (x0 & y0 & x1 & y1 & x2 & y2 & x3 & y3). intros hx hy.
  unfold winding, sides, crossing, crossed, crossed_upward, turn; simpl.
  rewrite x0, y0, x1, y1, x2, y2, x3, y3.
  repeat match goal with
    | |- context [Rle_dec ?a ?b] => destruct (Rle_dec a b); try lra
    | |- context [Rlt_dec ?a ?b] => destruct (Rlt_dec a b); try lra; try nra
    end; reflexivity.
Qed.

Theorem triangles_fill_the_rectangle triangles xq yq :
  (forall a b c, In (a, b, c) triangles -> 0 < turn (x a) (y a) (x b) (y b) (x c) (y c)) ->
  NoDup (flat_map edges_of triangles) ->
  (forall e, In e sides <->
     In e (flat_map edges_of triangles) /\ ~ In (reverse e) (flat_map edges_of triangles)) ->
  left <= xq < right -> low <= yq < high ->
  exists t, In t triangles /\ inside_or_on x y xq yq t /\
    forall s, In s triangles -> strictly_inside x y xq yq s -> s = t.
Proof.
  intros ccw once pairs hx hy. apply wound_once_is_in_one with sides; try assumption.
  - repeat constructor; simpl; intuition congruence.
  - apply rectangle_winds_once; assumption.
Qed.
End rectangle.
