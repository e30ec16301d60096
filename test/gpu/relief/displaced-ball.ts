import { BufferAttribute, BufferGeometry, Mesh, MeshStandardMaterial } from 'three'
import { interpolate } from '../../../packages/furrow/src/core/reference.ts'
import { displace } from '../../../packages/furrow/src/relief/displaced.ts'
import { outwardClearance } from '../../../packages/furrow/src/relief/outward-clearance.ts'
import { splitMesh } from '../../../packages/furrow/src/relief/split-mesh.ts'
import { MAX_LEVEL } from '../../../packages/furrow/src/relief/welded-edges.ts'
import { finish } from '../../unit/relief/coarse.ts'
import { AMPLITUDE, heightBytes } from './ball.ts'

/** Computes the surface of a ball with its blendshape and full relief in float64. */
export function displacedBall({ geometry, morphTargetInfluences }: Mesh) {
  const { attributes, index, morphAttributes } = geometry
  const rest = attributes.position.array as Float32Array
  const coarse = { positions: rest, uvs: attributes.uv.array, triangles: index!.array }
  const dense = finish(splitMesh(coarse, new Float32Array(index!.count).fill(MAX_LEVEL)))
  const normals = attributes.normal.array
  const clearance = finish(outwardClearance(coarse, normals, dense.firstOf, AMPLITUDE / 2))
  const offsets = morphAttributes.position![0].array
  const positions = Float64Array.from(rest, (value, i) => value + morphTargetInfluences![0] * offsets[i])
  const bytes = heightBytes()
  const side = Math.sqrt(bytes.length)
  const heightAt = (u: number, v: number) =>
    (interpolate({ width: side, height: side }, u, v, (i, j) => bytes[i + j * side]) / 255 - 0.5) * AMPLITUDE
  return {
    triangles: dense.triangles,
    positions: displace(dense, { positions, normals }, heightAt, clearance),
  }
}

/** Creates a mesh of the displaced ball, which can be drawn for comparison. */
export function displacedMesh(ball: Mesh): Mesh {
  const { triangles, positions } = displacedBall(ball)
  const geometry = new BufferGeometry()
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(positions), 3))
  geometry.setIndex(new BufferAttribute(triangles, 1))
  geometry.computeVertexNormals()
  return new Mesh(geometry, new MeshStandardMaterial({ color: 0, emissive: 0xffffff }))
}
