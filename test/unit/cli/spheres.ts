import { Document, NodeIO } from '@gltf-transform/core'
import { accessorsOf } from '../../accessors.ts'
import { cross, dot, minus, plus, unit, type Vector } from '../../vectors.ts'

export interface Shape {
  positions: number[]
  normals?: number[]
  uvs?: number[]
  tangents?: number[]
  indices: number[]
}

/** Makes a sphere from an icosahedron. Each triangle is split into four, `cuts` times. The radius is in metres. */
export function icosphere(radius: number, cuts: number): Shape {
  const g = (1 + Math.sqrt(5)) / 2
  const corners = [
    [-1, g, 0],
    [1, g, 0],
    [-1, -g, 0],
    [1, -g, 0],
  ] as Vector[]
  const points = [0, 1, 2].flatMap((turn) =>
    corners.map((c) => unit([c[(3 - turn) % 3]!, c[(4 - turn) % 3]!, c[(5 - turn) % 3]!])),
  )
  // Three corners that are pairwise neighbours form a face of the icosahedron. Orient it outwards.
  let faces: Vector[] = []
  const near = (i: number, j: number) => i !== j && dot(points[i]!, points[j]!) > 0.4
  for (let i = 0; i < 12; i++) {
    for (let j = i + 1; j < 12; j++) {
      for (let k = j + 1; k < 12; k++) {
        if (near(i, j) && near(j, k) && near(i, k)) faces.push(outwards(points, [i, j, k]))
      }
    }
  }
  for (let cut = 0; cut < cuts; cut++) {
    const middles = new Map<string, number>()
    const middle = (i: number, j: number) => {
      const key = i < j ? `${i} ${j}` : `${j} ${i}`
      if (!middles.has(key)) {
        const [p, q] = [points[i]!, points[j]!]
        middles.set(key, points.push(unit(plus(p, q))) - 1)
      }
      return middles.get(key)!
    }
    faces = faces.flatMap(([i, j, k]) => {
      const [ij, jk, ki] = [middle(i, j), middle(j, k), middle(k, i)]
      return [
        [i, ij, ki],
        [j, jk, ij],
        [k, ki, jk],
        [ij, jk, ki],
      ] as Vector[]
    })
  }
  return {
    positions: points.flat().map((value) => radius * value),
    normals: points.flat(),
    indices: faces.flat(),
  }
}

function outwards(points: Vector[], [i, j, k]: Vector): Vector {
  const [a, b, c] = [points[i]!, points[j]!, points[k]!]
  return dot(cross(minus(b, a), minus(c, a)), a) > 0 ? [i, j, k] : [i, k, j]
}

/**
 * Makes a coarse globe with u to the east and v to the south. It has no poles, because UVs would be ambiguous there.
 *
 * @param options `tilt`: rotation of the normals about the axis to the north, radians. `mirrored`: u points to the west.
 */
export function globe(radius: number, columns: number, rows: number, { tilt = 0, mirrored = false } = {}) {
  const shape = {
    positions: [] as number[],
    normals: [] as number[],
    uvs: [] as number[],
    indices: [] as number[],
  }
  for (let row = 0; row <= rows; row++) {
    for (let column = 0; column <= columns; column++) {
      const [u, v] = [column / columns, row / rows]
      const [east, north] = [(u - 0.5) * Math.PI * 1.9, (0.5 - v) * Math.PI * 0.8]
      const point = (turn: number) => [
        Math.cos(north) * Math.sin(east + turn),
        Math.sin(north),
        Math.cos(north) * Math.cos(east + turn),
      ]
      shape.positions.push(...point(0).map((value) => radius * value))
      shape.normals.push(...point(tilt))
      shape.uvs.push(mirrored ? 0.95 - 0.9 * u : 0.05 + 0.9 * u, 0.05 + 0.9 * v)
      if (row === rows || column === columns) continue
      const i = row * (columns + 1) + column
      shape.indices.push(i, i + columns + 1, i + 1, i + 1, i + columns + 1, i + columns + 2)
    }
  }
  return shape
}

/** Makes a rectangle from a corner and two edges in metres. The rectangle shows the complete texture. */
export function quad(corner: Vector, a: Vector, b: Vector): Shape {
  const normal = unit(cross(a, b))
  const at = (s: number, t: number) => corner.map((value, k) => value + s * a[k]! + t * b[k]!)
  return {
    positions: [...at(0, 0), ...at(1, 0), ...at(1, 1), ...at(0, 1)],
    normals: [0, 1, 2, 3].flatMap(() => normal),
    uvs: [0, 1, 1, 1, 1, 0, 0, 0],
    indices: [0, 1, 2, 0, 2, 3],
  }
}

/** Writes a .glb with a mesh and a node per shape. */
export async function writeGlb(path: string, shapes: Record<string, Shape>): Promise<void> {
  const document = new Document()
  const scene = document.createScene()
  const accessor = accessorsOf(document)
  for (const [name, { positions, normals, uvs, tangents, indices }] of Object.entries(shapes)) {
    const primitive = document
      .createPrimitive()
      .setAttribute('POSITION', accessor('VEC3', Float32Array.from(positions)))
      .setIndices(accessor('SCALAR', Uint32Array.from(indices)))
    if (normals) primitive.setAttribute('NORMAL', accessor('VEC3', Float32Array.from(normals)))
    if (uvs) primitive.setAttribute('TEXCOORD_0', accessor('VEC2', Float32Array.from(uvs)))
    if (tangents) primitive.setAttribute('TANGENT', accessor('VEC4', Float32Array.from(tangents)))
    scene.addChild(document.createNode(name).setMesh(document.createMesh(name).addPrimitive(primitive)))
  }
  await new NodeIO().write(path, document)
}
