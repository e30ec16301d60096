import { useSignal } from '@preact/signals'
import { DEFAULT_AREA_SIZE, WRINKLE_MAPS } from 'furrow/internal'
import { useId } from 'preact/hooks'
import { areaCost } from '../document/area-size.ts'
import type { StudioDocument } from '../document/document.ts'
import { PAGE } from '../labels/page.ts'
import { EXPORT, exportedLabel, otherErrorsLabel } from '../labels/project.ts'
import { REGION, regionCostLabel, sizeLabel } from '../labels/regions.ts'
import { Check } from '../panels/controls/check.tsx'
import type { PanelModel } from '../panels/model.ts'
import type { ExportState } from '../session/exporting.ts'
import { Icon } from '../ui/icon.tsx'
import { Popover } from '../ui/popover.tsx'

/** Returns the code that loads a file. Loaders scale areas to 128 texels unless an option tells otherwise. */
function codeFor(name: string, areaSize: number): string {
  const options = areaSize > DEFAULT_AREA_SIZE ? `, { areaSize: ${areaSize} }` : ''
  return `import { extendLoader } from 'furrow/three'

extendLoader(loader${options})
const { scene } = await loader.loadAsync('${name}')`
}

/** Button that exports the avatar and saves the file. Its card shows the progress, the size of the wrinkles, and code that loads the file. */
export function ExportCard({ model, document }: { model: PanelModel; document: StudioDocument }) {
  const { exporting, actions } = model
  const isCompressed = useSignal(false)
  const hasTakes = useSignal(true)
  const state = exporting.value
  return (
    <div class="export">
      <button
        type="button"
        class="main"
        onClick={() => actions.exportFace({ ktx2: isCompressed.value, takes: hasTakes.value })}
      >
        {EXPORT.export}
      </button>
      <Popover label={EXPORT.exported} class="main" placement="bottom-end" button={<Icon name="down" />}>
        <Check value={isCompressed} title={EXPORT.ktx2Hint}>
          {EXPORT.ktx2}
        </Check>
        {document.takes && (
          <Check value={hasTakes} title={EXPORT.takesHint}>
            {EXPORT.takes}
          </Check>
        )}
        <RegionCost document={document} />
        {!state && <p class="hint">{EXPORT.hint}</p>}
        {state?.kind === 'done' && (
          <Done state={state} areaSize={document.areaSize} onCopy={actions.copyCode} />
        )}
      </Popover>
      {state?.kind === 'running' && <Running fraction={state.fraction} onCancel={actions.cancelExport} />}
    </div>
  )
}

/** Size of the regions, and its cost. */
function RegionCost({ document }: { document: StudioDocument }) {
  return (
    <p class="hint">
      {REGION.size}: {sizeLabel(document.areaSize)}. {regionCostLabel(areaCost(document))}
    </p>
  )
}

function Running({ fraction, onCancel }: { fraction: number; onCancel(): void }) {
  const id = useId()
  return (
    <div class="run">
      <label for={id}>{EXPORT.running}</label>
      <progress id={id} max="1" value={fraction} />
      <button type="button" class="quiet" onClick={onCancel}>
        {PAGE.cancel}
      </button>
    </div>
  )
}

interface DoneProps {
  areaSize: number
  state: ExportState & { kind: 'done' }
  onCopy(text: string): void
}

function Done({ state, areaSize, onCopy }: DoneProps) {
  const { bytes, findings, cost, warnings } = state.face
  const errors = findings.filter(({ severity }) => severity === 'error')
  const own = errors.filter(({ pointer }) => pointer?.includes(WRINKLE_MAPS))
  const rest = errors.length - own.length
  const notes = [
    ...warnings,
    ...own.map(({ message }) => message),
    ...(rest > 0 ? [otherErrorsLabel(rest)] : []),
  ]
  return (
    <>
      <p class="hint" role="status">
        {exportedLabel(state.name, { all: bytes.length, wrinkles: cost.file, gpu: cost.gpu }, own.length)}
      </p>
      {notes.length > 0 && (
        <ul class="hint">
          {notes.map((note) => (
            <li key={note}>{note}</li>
          ))}
        </ul>
      )}
      <Code text={codeFor(state.name, areaSize)} onCopy={onCopy} />
    </>
  )
}

/** Text with a copy button. */
function Code({ text, onCopy }: { text: string; onCopy(text: string): void }) {
  return (
    <>
      <textarea class="code" readOnly rows={8} spellcheck={false} aria-label={EXPORT.code} value={text} />
      <button type="button" onClick={() => onCopy(text)}>
        {EXPORT.copyCode}
      </button>
    </>
  )
}
