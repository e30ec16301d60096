import { useSignal } from '@preact/signals'
import { useEffect } from 'preact/hooks'
import { displayName } from '../display-name.ts'
import { FILE } from '../labels/project.ts'
import { Recent } from '../panels/keeping/recent.tsx'
import { SaveProject } from '../panels/keeping/save-project.tsx'
import type { PanelModel } from '../panels/model.ts'
import { Icon } from '../ui/icon.tsx'
import { Popover } from '../ui/popover.tsx'
import { OpenButtons } from './open-buttons.tsx'

/** Name of the project, with a card that opens and saves projects. It closes when another avatar is shown, which it would cover. */
export function ProjectCard({ model }: { model: PanelModel }) {
  const { viewer, session } = model
  const shown = viewer.value?.avatar.name
  const name = shown === undefined ? '' : displayName(shown)
  const isOpen = useSignal(false)
  useEffect(() => {
    isOpen.value = false
  }, [viewer.value])
  return (
    <Popover
      isOpen={isOpen}
      label={`${FILE.project} ${name}`.trim()}
      class="project"
      button={
        <>
          <b>{name || FILE.project}</b>
          <Icon name="down" />
        </>
      }
    >
      <OpenButtons model={model} />
      <FaceChoice model={model} />
      <Recent model={model} />
      {session.document.value && <SaveProject model={model} />}
    </Popover>
  )
}

/** Select for shipped faces and the current avatar. */
function FaceChoice({ model: { faces, viewer, actions } }: { model: PanelModel }) {
  const shown = viewer.value?.avatar.name
  const names = shown === undefined || faces.value.includes(shown) ? faces.value : [...faces.value, shown]
  return (
    <div class="setting">
      <label for="face">{FILE.face}</label>
      <select
        id="face"
        value={shown ?? ''}
        onChange={({ currentTarget }) => actions.openFace(currentTarget.value)}
      >
        {names.map((name) => (
          <option key={name} value={name}>
            {displayName(name)}
          </option>
        ))}
      </select>
    </div>
  )
}
