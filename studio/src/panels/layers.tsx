import { MAX_BLOOD_AMPLITUDE } from 'furrow/internal'
import { useId, useRef } from 'preact/hooks'
import { MAP_NAMES, type MapName, type StudioLayer } from '../document/document.ts'
import { PLACES } from '../labels/page.ts'
import { SCULPT } from '../labels/sculpt.ts'
import type { LayerEditor } from '../session/layer-editor.ts'
import { Choice } from './controls/choice.tsx'
import { FileButton } from './controls/file-button.tsx'
import { NumberSlider } from './controls/number-slider.tsx'
import { Section } from './controls/section.tsx'
import type { PanelModel } from './model.ts'

const KINDS = [
  { value: 'detail', label: 'Detail', title: 'Wrinkles only, laid over the skin’s own normal map' },
  {
    value: 'replace',
    label: 'Replace',
    title: 'Wrinkles and pores that replace the skin’s own normal map',
  },
] as const

const MAP_LABELS: Record<MapName, string> = {
  normal: 'Normal',
  baseColor: 'Colour',
  roughness: 'Roughness',
  occlusion: 'Occlusion',
  height: 'Height',
  blood: 'Blood',
  onset: 'Onset',
}

const IMAGES = 'image/png,image/jpeg,image/webp'
const SCULPTS = '.glb,.gltf,.vrm'

interface LayersProps {
  model: PanelModel
  /** Layer of the selection, which is unfolded. */
  shown: string | undefined
}

/** Layers with their maps. */
export function Layers({ model: { layers, session, actions }, shown }: LayersProps) {
  const document = session.document.value
  const keys = useKeys(document?.layers.map(({ name }) => name) ?? [])
  if (!document) return null
  return (
    <Section title={PLACES.layers}>
      {document.layers.map((layer, i) => (
        <Layer
          key={keys[i]}
          layer={layer}
          isShown={layer.name === shown}
          isFirst={i === 0}
          isLast={i === document.layers.length - 1}
          hasStrokes={document.strokes.some((stroke) => stroke.layer === layer.name)}
          editor={layers}
          attempt={actions.attempt}
        />
      ))}
      <div class="add">
        <button type="button" onClick={() => layers.add()}>
          New layer
        </button>
        <button type="button" title="All layers and areas as images, in a .zip" onClick={() => layers.save()}>
          Save all maps
        </button>
        <button type="button" title="A template to paint regions over" onClick={actions.saveUvLayout}>
          Save UV layout
        </button>
      </div>
    </Section>
  )
}

/** Returns a key for each layer. A layer keeps its key when it is renamed, so that its form keeps the focus. */
function useKeys(names: readonly string[]): readonly number[] {
  const last = useRef({ names, keys: names.map((_, i) => i), free: names.length })
  const { names: old, keys, free } = last.current
  const isRenamed = names.length === old.length && names.filter((name) => !old.includes(name)).length === 1
  const next = names.map((name, i) => keys[isRenamed ? i : old.indexOf(name)] ?? free + i)
  last.current = { names, keys: next, free: Math.max(free, ...next.map((key) => key + 1)) }
  return next
}

interface LayerProps {
  layer: StudioLayer
  isShown: boolean
  isFirst: boolean
  isLast: boolean
  hasStrokes: boolean
  editor: LayerEditor
  /** Runs a task and shows its errors. */
  attempt(task: () => unknown): void
}

function Layer({ layer, isShown, isFirst, isLast, hasStrokes, editor, attempt }: LayerProps) {
  const { name, kind, normalScale, maps, heightAmplitude, bloodAmplitude, onsetStrength, isOnsetDrawn } =
    layer
  const { sculpted } = layer
  const id = useId()
  return (
    <details class="layer" open={isShown}>
      <summary>
        {name}
        <span>{kind}</span>
      </summary>
      <div class="settings">
        <div class="setting">
          <label for={id}>Name</label>
          <input
            id={id}
            type="text"
            aria-label={`Name of layer ${name}`}
            autocomplete="off"
            spellcheck={false}
            value={name}
            onChange={({ currentTarget }) => {
              editor.rename(name, currentTarget.value)
              // Show the old name, in case the new name is invalid. A valid name is shown when the document has changed.
              currentTarget.value = name
            }}
          />
        </div>
        <Choice
          label="Kind"
          options={KINDS}
          value={kind}
          onChange={(value) => editor.set(name, { kind: value })}
        />
        <NumberSlider
          label="Scale"
          range={[0, 2, 0.05]}
          value={normalScale}
          onMove={(value) => editor.set(name, { normalScale: value })}
          onRest={() => editor.settle()}
        />
        {maps.height && (
          <NumberSlider
            label="Height, mm"
            range={[0, 10, 0.1]}
            value={1000 * (heightAmplitude ?? 0)}
            onMove={(value) => editor.set(name, { heightAmplitude: value / 1000 })}
            onRest={() => editor.settle()}
          />
        )}
        {maps.blood && (
          <NumberSlider
            label="Blood"
            range={[0, MAX_BLOOD_AMPLITUDE, 0.05]}
            value={bloodAmplitude ?? 0}
            onMove={(value) => editor.set(name, { bloodAmplitude: value })}
            onRest={() => editor.settle()}
          />
        )}
        {(maps.onset || isOnsetDrawn) && (
          <NumberSlider
            label="Onset"
            range={[0, 1, 0.05]}
            value={onsetStrength ?? 1}
            onMove={(value) => editor.set(name, { onsetStrength: value })}
            onRest={() => editor.settle()}
          />
        )}
      </div>
      {MAP_NAMES.map((map) => (
        <MapRow
          key={map}
          layer={layer}
          map={map}
          isDrawn={hasStrokes && isDrawn(map, layer)}
          editor={editor}
          attempt={attempt}
        />
      ))}
      {sculpted && (
        <div class="map">
          <span class="label">{SCULPT.sculpted}</span>
          <button type="button" onClick={() => editor.resetSculpted(name)}>
            {SCULPT.reset}
          </button>
        </div>
      )}
      <Bake name={name} editor={editor} />
      <div class="add">
        <button
          type="button"
          aria-disabled={isFirst}
          aria-label={`Move ${name} up`}
          onClick={() => editor.move(name, -1)}
        >
          Up
        </button>
        <button
          type="button"
          aria-disabled={isLast}
          aria-label={`Move ${name} down`}
          onClick={() => editor.move(name, 1)}
        >
          Down
        </button>
        <button type="button" aria-label={`Remove layer ${name}`} onClick={() => editor.remove(name)}>
          Remove
        </button>
      </div>
    </details>
  )
}

/** Whether strokes are drawn into a map. */
function isDrawn(map: MapName, { isOnsetDrawn }: StudioLayer): boolean {
  return map === 'normal' || map === 'occlusion' || (map === 'onset' && isOnsetDrawn === true)
}

interface MapRowProps extends Pick<LayerProps, 'layer' | 'editor' | 'attempt'> {
  map: MapName
  isDrawn: boolean
}

function MapRow({ layer: { name, maps }, map, isDrawn, editor, attempt }: MapRowProps) {
  const label = MAP_LABELS[map]
  const hasImage = maps[map] !== undefined
  return (
    <div class="map">
      <span class="label">{label}</span>
      <span class="hint">{hasImage ? (isDrawn ? 'image + lines' : 'image') : isDrawn ? 'lines' : '–'}</span>
      <FileButton
        label={`Import ${map} of ${name}`}
        title={`Import ${label.toLowerCase()} map`}
        accept={IMAGES}
        onChoose={([file]) => attempt(() => editor.importMap(name, map, file))}
      >
        Import…
      </FileButton>
      <button
        type="button"
        disabled={!hasImage && !isDrawn}
        aria-label={`Save ${map} of ${name}`}
        onClick={() => editor.saveMap(name, map)}
      >
        Save
      </button>
      <button
        type="button"
        class="remove"
        disabled={!hasImage}
        title="Remove"
        aria-label={`Remove ${map} of ${name}`}
        onClick={() => editor.removeMap(name, map)}
      >
        ×
      </button>
    </div>
  )
}

/** Button that bakes a sculpt, which the user chooses or drops, into a normal map. Shows the progress. */
function Bake({ name, editor }: { name: string; editor: LayerEditor }) {
  const id = useId()
  const run = editor.run.value
  if (run?.layer === name) {
    return (
      <div class="run">
        <label for={id}>Baking</label>
        <progress id={id} max="1" value={run.fraction} />
        <button type="button" class="quiet" onClick={() => editor.cancelBake()}>
          Cancel
        </button>
      </div>
    )
  }
  return (
    <FileButton
      label={`Bake a sculpt into ${name}`}
      title="A detailed model of the wrinkled face, with the position and size of this face"
      accept={SCULPTS}
      isDropTarget
      onChoose={([file]) => editor.bake(name, file)}
    >
      Bake from a sculpt… or drop one here
    </FileButton>
  )
}
