/** Key of `localStorage`, and maximum number of remembered texts. */
const KEY = 'furrow-seen'
const MAX = 100

/** Whether a text was remembered in this browser. */
export function hasSeen(text: string): boolean {
  return all().includes(text)
}

/** Remembers a text in this browser. Does nothing if the browser denies storage. */
export function remember(text: string): void {
  const others = all().filter((each) => each !== text)
  try {
    localStorage.setItem(KEY, JSON.stringify([text, ...others].slice(0, MAX)))
  } catch {}
}

function all(): readonly string[] {
  try {
    const list: unknown = JSON.parse(localStorage.getItem(KEY) ?? '[]')
    return Array.isArray(list) ? list : []
  } catch {
    return []
  }
}
