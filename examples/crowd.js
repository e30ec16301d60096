/** Rows of instances of one face, each with a different expression, for crowd.html. Not part of the library. */

import { EXPRESSIONS } from 'furrow'
import { MeshoptSimplifier } from 'meshoptimizer/simplifier'
import { BufferAttribute, Group, InstancedMesh, Matrix4 } from 'three'

/** Distance between the centres of neighbouring faces, metres. */
const SPACING = { x: 0.28, y: 0.33 }
/** Duration of an expression, seconds. */
const DURATION = 2.4

/**
 * Creates instances of all meshes of a face, in rows and columns.
 *
 * @param {number} detail fraction of the triangles to keep.
 */
export async function createCrowd(face, count, detail) {
  await MeshoptSimplifier.ready
  const columns = Math.ceil(Math.sqrt(count * 1.7))
  const rows = Math.ceil(count / columns)
  const group = new Group()
  /**
   * Meshes of the face with their instances. `InstancedMesh.setMorphAt` copies the blendshape weights of a mesh to one
   * instance.
   */
  const parts = []
  face.updateMatrixWorld()
  face.traverse((mesh) => {
    if (mesh.isMesh) parts.push({ mesh, instances: createInstances(mesh) })
  })
  group.add(...parts.map(({ instances }) => instances))

  function createInstances(mesh) {
    const instances = new InstancedMesh(simplify(mesh.geometry, detail), mesh.material.clone(), count)
    instances.morphTargetDictionary = mesh.morphTargetDictionary
    instances.frustumCulled = false
    for (let i = 0; i < count; i++) instances.setMatrixAt(i, matrixOf(i).multiply(mesh.matrixWorld))
    return instances
  }

  function matrixOf(i) {
    const x = ((i % columns) - (columns - 1) / 2) * SPACING.x
    const y = ((rows - 1) / 2 - Math.floor(i / columns)) * SPACING.y
    const yaw = Math.sin(i * 12.9) * 0.35
    return new Matrix4().makeRotationY(yaw).setPosition(x, y - 0.75, 0)
  }

  return {
    group,
    width: columns * SPACING.x,
    height: rows * SPACING.y,
    instancesOf: (wanted) => parts.find(({ mesh }) => mesh === wanted).instances,

    /** Plays the expressions on every face. Each face is at another moment of the sequence. */
    express(seconds) {
      for (let i = 0; i < count; i++) {
        const phase = seconds / DURATION + i * 0.618
        const { targets } = EXPRESSIONS[(Math.floor(phase) + i) % EXPRESSIONS.length]
        setTargets(parts, i, targets, Math.sin(Math.PI * (phase % 1)) ** 2)
      }
      for (const { instances } of parts) {
        if (instances.morphTexture) instances.morphTexture.needsUpdate = true
      }
    },
  }
}

function simplify(original, detail) {
  const geometry = original.clone()
  const positions = geometry.getAttribute('position').array
  const triangles = Uint32Array.from(geometry.index.array)
  const indexCount = 3 * Math.floor(Math.max(400, (triangles.length / 3) * detail))
  const [index] = MeshoptSimplifier.simplify(triangles, positions, 3, indexCount, 1, ['LockBorder'])
  return geometry.setIndex(new BufferAttribute(index, 1))
}

function setTargets(parts, i, targets, weight) {
  for (const { mesh, instances } of parts) {
    if (!mesh.morphTargetInfluences) continue
    mesh.morphTargetInfluences.fill(0)
    for (const name in targets) {
      const target = mesh.morphTargetDictionary[name]
      if (target !== undefined) mesh.morphTargetInfluences[target] = targets[name] * weight
    }
    instances.setMorphAt(i, mesh)
  }
}
