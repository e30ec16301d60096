import type { Mesh } from 'three'
import { MESHES, PLACES, showMeshLabel } from '../labels/page.ts'
import { Section } from '../panels/controls/section.tsx'
import type { PanelModel } from '../panels/model.ts'
import { Icon } from '../ui/icon.tsx'

/** List of the avatar's meshes, which users can hide, and the choice of the mesh that gets wrinkles. */
export function MeshList({ model }: { model: PanelModel }) {
  const { viewer, meshes } = model
  const all = viewer.value?.meshes ?? []
  if (all.length < 2) return null
  const hidden = meshes.hidden.value
  return (
    <Section title={PLACES.meshes}>
      <ul class="meshes" aria-label={PLACES.meshes}>
        {namesOf(all).map((name, i) => (
          <li key={name}>
            <span>{name}</span>
            <button
              type="button"
              class="toggle"
              aria-label={showMeshLabel(name)}
              title={hidden.has(all[i]) ? MESHES.show : MESHES.hide}
              aria-pressed={!hidden.has(all[i])}
              onClick={() => meshes.toggle(all[i])}
            >
              <Icon name="eye" />
            </button>
          </li>
        ))}
      </ul>
      <SkinChoice model={model} />
    </Section>
  )
}

/** Returns a unique name for each mesh. */
function namesOf(meshes: readonly Mesh[]): string[] {
  const names = meshes.map(({ name, parent }) => name || parent?.name || MESHES.unnamed)
  return names.map((name, i) => (names.indexOf(name) === i ? name : `${name} ${i + 1}`))
}

/** Select for the skin mesh, if there are several. */
function SkinChoice({ model: { viewer, actions } }: { model: PanelModel }) {
  const avatar = viewer.value?.avatar
  if (!avatar || avatar.skins.length < 2) return null
  return (
    <div class="setting">
      <label for="skin">{MESHES.skin}</label>
      <select
        id="skin"
        value={avatar.skin}
        onChange={({ currentTarget }) => actions.chooseSkin(Number(currentTarget.value))}
      >
        {avatar.skins.map(({ name, problem }, i) => (
          <option key={name} value={i} disabled={problem !== null} title={problem ?? undefined}>
            {name}
          </option>
        ))}
      </select>
    </div>
  )
}
