/** Lets the browser handle pending messages and events, and resolves in a new task. */
export function nextTask(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve))
}

/** Maximum wait in `whenIdle`, milliseconds. A page with a moving face is never idle. */
const MAX_WAIT = 200

/** Resolves when the page is idle, or after `MAX_WAIT`. */
export function whenIdle(): Promise<void> {
  return new Promise((resolve) => {
    // Safari lacks requestIdleCallback.
    if (typeof requestIdleCallback === 'undefined') setTimeout(resolve, MAX_WAIT)
    else requestIdleCallback(() => resolve(), { timeout: MAX_WAIT })
  })
}

let last = Promise.resolve()

/** Queues a task until all earlier tasks are done and the page is idle. Returns a function that cancels the task. */
export function runInTurn(task: () => void): () => void {
  let isWanted = true
  last = last
    .then(() => (isWanted ? whenIdle() : undefined))
    .then(() => {
      if (isWanted) task()
    })
    .catch((error) => reportError(error))
  return () => {
    isWanted = false
  }
}
