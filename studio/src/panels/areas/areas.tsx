import { useLayoutEffect, useRef } from 'preact/hooks'
import type { StudioDocument } from '../../document/document.ts'
import { splitSide } from '../../document/sides.ts'
import { regionLabel } from '../../labels/names.ts'
import { PLACES } from '../../labels/page.ts'
import { REGION, regionLabels } from '../../labels/regions.ts'
import type { AreaEditor } from '../../session/area-editor.ts'
import { Icon } from '../../ui/icon.tsx'
import type { Dial } from '../../viewer/pose/dials.ts'
import { Check } from '../controls/check.tsx'
import { FileButton } from '../controls/file-button.tsx'
import { Section } from '../controls/section.tsx'
import { Slider } from '../controls/slider.tsx'
import type { PanelModel } from '../model.ts'
import { AreaThumbnail } from './area-thumbnail.tsx'

/** Sliders of all areas, which the page calls regions, and buttons to add areas. */
export function Areas({ model }: { model: PanelModel }) {
  const { session, areas, viewer, revision, frame, hovered, actions } = model
  revision.value
  const document = session.document.value
  const dials = sortDials(viewer.value?.areas ?? [], document)
  const list = useRef<HTMLDivElement>(null)
  const removed = useRef(-1)
  // After a row is removed, focus the row that now has its index.
  useLayoutEffect(() => {
    if (removed.current < 0) return
    const buttons = list.current!.querySelectorAll<HTMLButtonElement>('.remove')
    buttons[Math.min(removed.current, buttons.length - 1)]?.focus()
    removed.current = -1
  }, [dials.length])
  const target = hovered.value?.kind === 'target' ? hovered.value.name : undefined
  const driven = target === undefined ? [] : (viewer.value?.driven.drivenBy(target) ?? [])
  const onHover = (dial: Dial | null) => {
    hovered.value = dial && { kind: 'area', name: dial.name }
  }
  const reset = (
    <button type="button" class="quiet" aria-label={REGION.resetAll} onClick={() => actions.reset(dials)}>
      {REGION.reset}
    </button>
  )
  return (
    <Section title={PLACES.regions} aside={reset}>
      <div id="areas" class="rows" ref={list}>
        {dials.map((dial, index) => (
          <Slider
            key={dial.name}
            dial={dial}
            label={regionLabel(dial.name)}
            frame={frame}
            linked={driven.includes(dial.name)}
            onInput={actions.input}
            onHover={onHover}
            before={document && <ChooseArea name={dial.name} model={model} />}
          >
            {document && <ShownToggles name={dial.name} areas={areas} />}
            {!document && (
              <button
                type="button"
                class="remove"
                title={REGION.removeRow}
                aria-label={regionLabels(dial.name).remove}
                onClick={() => {
                  removed.current = index
                  actions.removeArea(dial.name)
                }}
              >
                ×
              </button>
            )}
          </Slider>
        ))}
      </div>
      <AddAreas model={model} />
    </Section>
  )
}

/** Sorts areas as in the document, and puts the two sides of a region next to each other. */
function sortDials(dials: readonly Dial[], document: StudioDocument | null): readonly Dial[] {
  const names = (document?.areas ?? dials).map(({ name }) => name)
  const first = new Map<string, number>()
  for (const [i, name] of names.entries()) {
    const [stem] = splitSide(name)
    if (!first.has(stem)) first.set(stem, i)
  }
  const indexOf = ({ name }: Dial) => first.get(splitSide(name)[0]) ?? names.length
  return dials.toSorted((a, b) => indexOf(a) - indexOf(b) || names.indexOf(a.name) - names.indexOf(b.name))
}

/** Radio button that looks like the area's thumbnail. */
function ChooseArea({ name, model }: { name: string; model: PanelModel }) {
  const { areas, hovered, actions } = model
  const point = (isHere: boolean) => {
    hovered.value = isHere ? { kind: 'area', name } : null
  }
  return (
    <span
      class="choose"
      onPointerMove={({ pointerType, movementX, movementY }) => {
        const isHovered = hovered.peek()?.name === name
        if (pointerType === 'mouse' && !isHovered && (movementX !== 0 || movementY !== 0)) point(true)
      }}
      onPointerLeave={({ pointerType }) => pointerType === 'mouse' && point(false)}
    >
      <input
        type="radio"
        name="chosen-area"
        title={REGION.select}
        aria-label={regionLabels(name).select}
        checked={areas.chosen.value?.name === name}
        onChange={() => actions.selectRegion(name)}
        onFocus={({ currentTarget }) => {
          // Ignore focus by a click. The pointer is then already on the area.
          if (currentTarget.matches(':focus-visible')) point(true)
        }}
        onBlur={() => {
          if (hovered.peek()?.name === name) point(false)
        }}
      />
      <AreaThumbnail name={name} model={model} />
    </span>
  )
}

/** Buttons for solo and mute, which change the face on the stage but not the document. */
function ShownToggles({ name, areas }: { name: string; areas: AreaEditor }) {
  const labels = regionLabels(name)
  return (
    <>
      <button
        type="button"
        class="toggle"
        title={REGION.soloHint}
        aria-label={labels.solo}
        aria-pressed={areas.soloed.value.has(name)}
        onClick={() => areas.toggleSolo(name)}
      >
        S
      </button>
      <button
        type="button"
        class="toggle"
        title={REGION.hideHint}
        aria-label={labels.hide}
        aria-pressed={areas.muted.value.has(name)}
        onClick={() => areas.toggleMute(name)}
      >
        <Icon name="eye" />
      </button>
    </>
  )
}

function AddAreas({ model: { session, areas, actions } }: { model: PanelModel }) {
  const { isPaper } = areas
  return (
    <>
      <div class="add">
        {session.document.value && (
          <button type="button" onClick={() => areas.addEmpty()}>
            {REGION.add}
          </button>
        )}
        <FileButton accept="image/*" describedBy="add-hint" isMultiple onChoose={actions.addAreaImages}>
          {REGION.addImage}
        </FileButton>
        <Check value={isPaper}>{REGION.paper}</Check>
      </div>
      <p id="add-hint" class="hint">
        {REGION.imageHint}
      </p>
    </>
  )
}
