import type { Document, Mesh, Node } from '@gltf-transform/core'
import { simplify, weld } from '@gltf-transform/functions'
import { MeshoptSimplifier } from 'meshoptimizer/simplifier'
import { noName, swapSide } from './rigs/naming-schemes.ts'

/** Lists the meshes with blendshapes, and the names of their blendshapes. */
function blendMeshes(document: Document): { mesh: Mesh; names: string[] }[] {
  return document
    .getRoot()
    .listMeshes()
    .flatMap((mesh) => {
      const names = mesh.getExtras().targetNames as string[] | undefined
      return names ? [{ mesh, names }] : []
    })
}

/** Renames blendshapes. `rename` receives a name, and its index among the different names of all meshes. */
export function renameTargets(document: Document, rename: (name: string, index: number) => string): void {
  const all = [...new Set(blendMeshes(document).flatMap(({ names }) => names))]
  for (const { mesh, names } of blendMeshes(document)) {
    const targetNames = names.map((name) => rename(name, all.indexOf(name)))
    mesh.setExtras({ ...mesh.getExtras(), targetNames })
    for (const primitive of mesh.listPrimitives())
      for (const [i, target] of primitive.listTargets().entries()) target.setName(targetNames[i]!)
  }
}

/** Renames the blendshapes to `target_0`, `target_1` ... */
export function removeNames(document: Document): void {
  renameTargets(document, (_, index) => noName(index))
}

/** Swaps left and right in the names of blendshapes, without changing their shapes. */
export function swapSides(document: Document): void {
  renameTargets(document, swapSide)
}

/** Removes all blendshapes but those that `isKept` accepts. */
export function keepTargets(document: Document, isKept: (name: string) => boolean): void {
  for (const { mesh, names } of blendMeshes(document)) {
    const kept = names.filter(isKept)
    for (const primitive of mesh.listPrimitives()) {
      const targets = primitive.listTargets()
      for (const [i, name] of names.entries()) if (!isKept(name)) primitive.removeTarget(targets[i]!)
    }
    mesh.setWeights(kept.map(() => 0)).setExtras({ ...mesh.getExtras(), targetNames: kept })
  }
}

/** Makes the scene's root nodes children of a new node with a scale or rotation. A negative scale mirrors the scene. */
export function placeScene(
  document: Document,
  { scale, rotation }: { scale?: [number, number, number]; rotation?: [number, number, number, number] },
): Node {
  const scene = document.getRoot().listScenes()[0]!
  const node = document.createNode('placed')
  for (const child of scene.listChildren()) node.addChild(child)
  scene.addChild(node)
  if (scale) node.setScale(scale)
  if (rotation) node.setRotation(rotation)
  return node
}

/** Removes meshes by name, such as the eyes. */
export function removeMeshes(document: Document, names: RegExp): void {
  for (const mesh of document.getRoot().listMeshes()) if (names.test(mesh.getName())) mesh.dispose()
}

/** Folds the UVs of the right half onto the left half, so that both halves use the same texels. */
export function foldUvs(document: Document): void {
  const primitives = document
    .getRoot()
    .listMeshes()
    .flatMap((mesh) => mesh.listPrimitives())
  for (const uvs of new Set(primitives.map((primitive) => primitive.getAttribute('TEXCOORD_0')))) {
    for (let i = 0; uvs && i < uvs.getCount(); i++) {
      const [u, v] = uvs.getElement(i, [0, 0])
      uvs.setElement(i, [0.5 + Math.abs(u - 0.5), v])
    }
  }
}

/** Simplifies all meshes and their blendshapes. `ratio` is the approximate fraction of vertices that remain. */
export async function decimate(document: Document, ratio: number): Promise<void> {
  await MeshoptSimplifier.ready
  await document.transform(weld(), simplify({ simplifier: MeshoptSimplifier, ratio, error: 1 }))
}
