import { KeepStatus } from './keeping/keep-status.tsx'
import type { PanelModel } from './model.ts'

/** Formats that the file dialog offers. */
const FACES = '.glb,.gltf,.vrm,.bin,.png,.jpg,.jpeg,.webp,.ktx2,.json,.zip,.csv'

/** Lets a dialog choose a folder, for which JSX has no name. */
function chooseFolder(input: HTMLInputElement | null): void {
  if (input) input.webkitdirectory = true
}

/** The name of the page, and what concerns the whole work: open, undo, redo. */
export function Title({ model }: { model: PanelModel }) {
  const { session, viewer, revision, actions } = model
  const { undoLabel, redoLabel } = session
  revision.value
  // What the file has is shown as it is, until it is to be changed.
  const isEditable = Boolean(viewer.value?.wrinkles) && !session.document.value
  return (
    <header class="title">
      <div>
        <h1>Furrow</h1>
        <p>Wrinkles for any glTF character, in real time</p>
      </div>
      <div class="work">
        <label class="file">
          <input
            type="file"
            accept={FACES}
            multiple
            onChange={({ currentTarget }) => {
              actions.openFiles([...currentTarget.files!])
              currentTarget.value = ''
            }}
          />
          <span>Open…</span>
        </label>
        <label class="file">
          <input
            type="file"
            ref={chooseFolder}
            onChange={({ currentTarget }) => {
              actions.openFiles([...currentTarget.files!])
              currentTarget.value = ''
            }}
          />
          <span>Open folder…</span>
        </label>
        {/* Without an end they keep the focus, so that one key may be pressed until all is undone. */}
        <button
          type="button"
          aria-disabled={!undoLabel.value}
          title={undoLabel.value && `Undo: ${undoLabel.value}`}
          onClick={() => session.undo()}
        >
          Undo
        </button>
        <button
          type="button"
          aria-disabled={!redoLabel.value}
          title={redoLabel.value && `Redo: ${redoLabel.value}`}
          onClick={() => session.redo()}
        >
          Redo
        </button>
        <button
          type="button"
          title="Copy a link to this expression, view and avatar"
          onClick={actions.copyLink}
        >
          Copy link
        </button>
        <button
          type="button"
          aria-label="Shortcuts"
          title="Shortcuts (?)"
          onClick={() => {
            model.isListOpen.value = true
          }}
        >
          ?
        </button>
        {isEditable && (
          <button type="button" onClick={actions.editWrinkles}>
            Edit wrinkles
          </button>
        )}
      </div>
      <KeepStatus model={model} />
    </header>
  )
}
