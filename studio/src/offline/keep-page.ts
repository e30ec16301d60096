/** Makes the built page work offline from the second visit on. Does nothing in development and on insecure pages. */
export function keepPage(): void {
  if (!import.meta.env.PROD || !('serviceWorker' in navigator)) return
  // Ignore failures: without a service worker, the page still works online.
  navigator.serviceWorker.register('service-worker.js').catch(() => {})
}
