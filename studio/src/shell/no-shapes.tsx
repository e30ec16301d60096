import type { SkinnedMesh } from 'three'
import { autoCommand, cannotWrinkleLabel, NO_SHAPES } from '../labels/page.ts'
import type { Viewer } from '../viewer/viewer.ts'

/** Tells why a skin cannot wrinkle, and how to change that. */
export function CannotWrinkle({ skin: { name, problem } }: { skin: Viewer['avatar']['skins'][number] }) {
  return <p class="hint no-shapes">{cannotWrinkleLabel(name, problem)}</p>
}

/** Tells what can be done with an avatar that has no blendshapes, and so no expressions. */
export function NoShapes({ viewer: { avatar, meshes } }: { viewer: Viewer }) {
  const skin = avatar.skins[avatar.skin]
  if (skin.problem !== null) return <CannotWrinkle skin={skin} />
  if (skin.wrinkles)
    return (
      <p class="hint no-shapes">
        {NO_SHAPES.none} {NO_SHAPES.regions}
      </p>
    )
  const hasJoints = meshes.some((mesh) => (mesh as Partial<SkinnedMesh>).isSkinnedMesh)
  return (
    <p class="hint no-shapes">
      {NO_SHAPES.none}{' '}
      {hasJoints && (
        <>
          {NO_SHAPES.joints} <code>{autoCommand(avatar.files[0].path.split('/').at(-1)!)}</code>.{' '}
        </>
      )}
      {NO_SHAPES.lines}
    </p>
  )
}
