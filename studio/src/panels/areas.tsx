import { useSignal } from '@preact/signals'
import { useLayoutEffect, useRef } from 'preact/hooks'
import type { Dial } from '../viewer/dials.ts'
import type { PanelModel } from './model.ts'
import { Section } from './section.tsx'
import { Slider } from './slider.tsx'

/** A slider per area, each with a button that removes it, and a field that adds areas from images. */
export function Areas({ model }: { model: PanelModel }) {
  const { viewer, revision, frame, hovered, actions } = model
  revision.value
  const dials = viewer.value?.areas ?? []
  const list = useRef<HTMLDivElement>(null)
  const removed = useRef(-1)
  // The focus stays at the same index when a row is removed.
  useLayoutEffect(() => {
    if (removed.current < 0) return
    const buttons = list.current!.querySelectorAll<HTMLButtonElement>('.remove')
    buttons[Math.min(removed.current, buttons.length - 1)]?.focus()
    removed.current = -1
  }, [dials.length])
  const target = hovered.value?.kind === 'target' ? hovered.value.name : undefined
  const driven = target === undefined ? [] : (viewer.value?.drivenBy(target) ?? [])
  const onHover = (dial: Dial | null) => {
    hovered.value = dial && { kind: 'area', name: dial.name }
  }
  const reset = (
    <button type="button" class="quiet" aria-label="Reset all areas" onClick={() => actions.reset(dials)}>
      Reset
    </button>
  )
  return (
    <Section title="Areas" aside={reset}>
      <div id="areas" class="rows" ref={list}>
        {dials.map((dial, index) => (
          <Slider
            key={dial.name}
            dial={dial}
            frame={frame}
            linked={driven.includes(dial.name)}
            onInput={actions.input}
            onHover={onHover}
          >
            <button
              type="button"
              class="remove"
              title="Remove"
              aria-label={`Remove area ${dial.name}`}
              onClick={() => {
                removed.current = index
                actions.removeArea(dial.name)
              }}
            >
              ×
            </button>
          </Slider>
        ))}
      </div>
      <Explanation model={model} />
      <AddAreas model={model} />
    </Section>
  )
}

/** What drives the area that is hovered, one line each. */
function Explanation({ model: { viewer, hovered } }: { model: PanelModel }) {
  const area = hovered.value?.kind === 'area' ? hovered.value.name : undefined
  if (area === undefined) return null
  return (
    <p class="explanation">
      {viewer.value?.explain(area).map((line) => (
        <>
          {line}
          <br />
        </>
      ))}
    </p>
  )
}

function AddAreas({ model: { actions } }: { model: PanelModel }) {
  const isPaper = useSignal(true)
  return (
    <>
      <div class="add">
        <label class="file">
          <input
            type="file"
            accept="image/*"
            multiple
            aria-describedby="add-hint"
            onChange={({ currentTarget }) => {
              actions.addAreaImages([...currentTarget.files!], isPaper.value ? 'paper' : 'weight')
              // Otherwise choosing the same file again would not be a change.
              currentTarget.value = ''
            }}
          />
          <span>Add area…</span>
        </label>
        <label class="check">
          <input
            type="checkbox"
            checked={isPaper.value}
            onChange={({ currentTarget }) => {
              isPaper.value = currentTarget.checked
            }}
          />
          White = no wrinkles
        </label>
      </div>
      <p id="add-hint" class="hint">
        Or drop a gray image anywhere. In the paper's convention black shows wrinkles; clear the box if white
        does.
      </p>
    </>
  )
}
