import type { ComponentChildren } from 'preact'

interface SectionProps {
  title: string
  /** Id of the contained list or fieldset. */
  id?: string
  /** Content beside the title, such as buttons or counts. */
  aside?: ComponentChildren
  /** Whether the section is initially open. */
  open?: boolean
  onToggle?(isOpen: boolean): void
  children: ComponentChildren
}

export function Section({ title, id, aside, open = true, onToggle, children }: SectionProps) {
  return (
    <details class="section" open={open} onToggle={({ currentTarget }) => onToggle?.(currentTarget.open)}>
      <summary>
        <h2 id={id && `${id}-title`}>{title}</h2>
      </summary>
      {aside && <div class="aside">{aside}</div>}
      {children}
    </details>
  )
}
