interface FileButtonProps {
  /** Text of the button. */
  children: string
  /** Accessible name, if it differs from the text. */
  label?: string
  /** File types, as in the attribute `accept`. */
  accept?: string
  title?: string
  /** ID of the element with a description. */
  describedBy?: string
  isMultiple?: boolean
  isFolder?: boolean
  /** Whether files can also be dropped on the button. */
  isDropTarget?: boolean
  onChoose(files: File[]): void
}

/** Button that lets the user choose files or a folder. */
export function FileButton(props: FileButtonProps) {
  const { children, label, accept, title, describedBy, isMultiple, isFolder, isDropTarget, onChoose } = props
  return (
    <label
      class={isDropTarget ? 'file wide' : 'file'}
      title={title}
      onDrop={(event) => {
        const files = [...(event.dataTransfer?.files ?? [])]
        if (!isDropTarget || files.length === 0) return
        event.preventDefault()
        onChoose(files)
      }}
    >
      <input
        type="file"
        accept={accept}
        aria-label={label}
        aria-describedby={describedBy}
        multiple={isMultiple}
        ref={isFolder ? chooseFolder : null}
        onChange={({ currentTarget }) => {
          const files = [...currentTarget.files!]
          // Otherwise the browser sends no event if the user chooses the same file again.
          currentTarget.value = ''
          if (files.length > 0) onChoose(files)
        }}
      />
      <span>{children}</span>
    </label>
  )
}

/** Makes a file input choose folders, by an attribute that JSX lacks. */
function chooseFolder(input: HTMLInputElement | null): void {
  if (input) input.webkitdirectory = true
}
