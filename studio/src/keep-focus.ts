const FOCUSABLE =
  'button:not(:disabled), input:not(:disabled), select:not(:disabled), textarea, summary, [tabindex="0"]'

/**
 * Keeps the focus of the keyboard on the page. Where what has it is removed (a row that is deleted, a form that undo takes away, a message
 * that is dismissed), it goes to what stands there then; where there is nothing, to what had it before.
 *
 * @param page holds all that can have the focus, in landmarks.
 */
export function keepFocus(page: HTMLElement): void {
  let held: Held | null = null
  let before: Held | null = null
  let isKeyboard = false
  page.addEventListener('keydown', () => (isKeyboard = true), { capture: true })
  page.addEventListener('pointerdown', () => (isKeyboard = false), { capture: true })
  page.addEventListener('focusin', ({ target }) => {
    if (held?.element.isConnected) before = held
    held = hold(target as HTMLElement)
  })
  page.addEventListener('focusout', ({ target, relatedTarget }) => {
    const { isConnected } = target as HTMLElement
    // Left for nothing by the user, and not by its removal, before or during which browsers tell this.
    queueMicrotask(() => {
      if (!relatedTarget && isConnected && (target as HTMLElement).isConnected) held = null
    })
  })
  new MutationObserver(() => {
    if (!held || isFocusable(held.element) || document.activeElement !== document.body) return
    const next = successorOf(held) ?? (before && isFocusable(before.element) ? before.element : null)
    held = null
    if (isKeyboard) next?.focus()
  }).observe(page, {
    childList: true,
    subtree: true,
    attributes: true,
    attributeFilter: ['disabled', 'hidden'],
  })
}

/** What has the focus, and where it stands: each of its ancestors up to the landmark, with the index of the child that it is in. */
interface Held {
  readonly element: HTMLElement
  readonly path: readonly (readonly [ancestor: Element, index: number])[]
}

function hold(element: HTMLElement): Held {
  const path: [Element, number][] = []
  let child: Element = element
  while (child.parentElement && !child.matches('main, aside, dialog, body')) {
    path.push([child.parentElement, [...child.parentElement.children].indexOf(child)])
    child = child.parentElement
  }
  // The landmark has too much in it to be beside anything.
  return { element, path: path.slice(0, -1) }
}

function isFocusable(element: HTMLElement): boolean {
  return element.isConnected && !element.matches(':disabled') && element.checkVisibility()
}

/** What stands now where an element stood: of its own kind in the row that has moved up, or else what is nearest. */
function successorOf({ element, path }: Held): HTMLElement | null {
  for (const [ancestor, index] of path) {
    if (!ancestor.isConnected || !ancestor.checkVisibility()) continue
    const children = [...ancestor.children]
    const near = [...children.slice(index), ...children.slice(0, index).reverse()]
    for (const child of near) {
      const inside = [child, ...child.querySelectorAll(FOCUSABLE)].filter(
        (each): each is HTMLElement => each.matches(FOCUSABLE) && isFocusable(each as HTMLElement),
      )
      if (inside.length > 0)
        return inside.find(({ className }) => className === element.className) ?? inside[0]
    }
  }
  return null
}
