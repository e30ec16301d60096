import { AutoProgress } from './auto-progress.tsx'
import { KeepStatus } from './keeping/keep-status.tsx'
import type { PanelModel } from './model.ts'

const FACES = '.glb,.gltf,.vrm,.bin,.png,.jpg,.jpeg,.webp,.ktx2,.json,.zip,.csv'

/** Makes a file input choose folders, by an attribute that JSX lacks. */
function chooseFolder(input: HTMLInputElement | null): void {
  if (input) input.webkitdirectory = true
}

/** Page title and global actions: open, undo, redo. */
export function Title({ model }: { model: PanelModel }) {
  const { session, viewer, revision, actions } = model
  const { undoLabel, redoLabel } = session
  revision.value
  // Wrinkles in the avatar's file cannot be edited until the user presses "Edit wrinkles".
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
        {/* A button with `aria-disabled` keeps the focus, so that users can undo everything by pressing a key repeatedly. */}
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
      {/* Only for a new avatar. With a document, the section of automatic wrinkles shows the progress. */}
      {!session.document.value && <AutoProgress model={model} />}
      <KeepStatus model={model} />
    </header>
  )
}
