// SPDX-License-Identifier: MIT
//
// The mesher, its auditor and the certificate. y points upwards, as in a mathematician's drawing.
//
// What is refused, with the program's words: RangeError. Arguments of the wrong shape: TypeError.

/** A polygon in numbers. `segments` are pairs of indices; by default the points are a closed chain. A hole is a
 * point in it; a region is x, y and its number. */
export interface Polygon {
  points: ArrayLike<number> | readonly (readonly [number, number])[];
  segments?: ArrayLike<number> | readonly (readonly [number, number])[];
  markers?: ArrayLike<number>;
  holes?: ArrayLike<number> | readonly (readonly [number, number])[];
  regions?: ArrayLike<number> | readonly (readonly [number, number, number])[];
}
/** A file in a format that the program reads (.poly, .geojson, .wkt, .mesh), told by the ending of its name. `files`
 * are those that belong to it, by name. */
export interface DomainFile { name: string; text: string; files?: Record<string, string>; }
export type Domain = 'square' | 'airfoil' | Polygon | DomainFile;

/** As --metric takes it, but for files: or a function, which returns m11, m12, m22 at a place. */
export type Metric = string | ((x: number, y: number) => ArrayLike<number>);

/** The command's options, with its defaults. */
export interface MeshOptions {
  size?: number;
  angleBound?: number;
  refine?: 'fill' | 'voronoi' | 'darts';
  gradation?: number;
  metricTolerance?: number;
  tol?: number;
  chordTolerance?: number;
  randomPoints?: number;
  seed?: number;
  maxSites?: number;
  improve?: number;
  proveVoronoi?: boolean;
  regions?: boolean;
  repairDomain?: boolean;
  repairDistance?: number;
  strict?: boolean;
}

export interface Arrays {
  /** x, y, m11, m12, m22 of each vertex. */
  readonly sites: Float64Array;
  /** Three vertices each, counter-clockwise. */
  readonly triangles: Uint32Array;
  /** Of each triangle. */
  readonly regions: Int32Array;
  /** Two vertices of each boundary subsegment, the domain on its left. */
  readonly edges: Uint32Array;
  readonly markers: Int32Array;
}

export interface Mesh extends Arrays {
  /** The mesher reached its goal. */
  readonly complete: boolean;
  /** And the auditor found nothing against the mesh. */
  readonly certified: boolean;
  /** Why the run ended. */
  readonly reason: string;
  /** Degrees, of all triangles as each of their vertices measures them. */
  readonly worstAngle: number;
  readonly witnesses: string[];
  /** What was changed of the domain, or passed over. */
  readonly notes: string[];
  /** The texts that the command writes as NAME.mesh, NAME.sol and NAME.certificate.json. */
  readonly files: { mesh: string; solution: string; certificate: string };
}

export interface Verdict extends Arrays {
  readonly certified: boolean;
  readonly worstAngle: number;
  /** What is against it, or contradicts the certificate. */
  readonly witnesses: string[];
}

export interface Mesher {
  readonly mesh: (domain: Domain, metric?: Metric, options?: MeshOptions) => Promise<Mesh>;
  /** Judges a mesh again, against the domain and the bound of its certificate. */
  readonly verify: (files: { mesh: string; solution: string; certificate: string }) => Promise<Verdict>;
  /** Judges a mesh from elsewhere, whose domain is what it covers. `certificate` is empty where it is refused. */
  readonly certify: (files: { mesh: string; solution: string }, options?: { angleBound?: number }) => Promise<Verdict & { certificate: string }>;
  readonly version: string;
}

export declare const mesh: Mesher['mesh'];
export declare const verify: Mesher['verify'];
export declare const certify: Mesher['certify'];
export declare const version: Mesher['version'];
