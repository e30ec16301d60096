/** Lets the built page work without a network from its next visit on. Pages that are not served securely, and in development, always need one. */
export function keepPage(): void {
  if (!import.meta.env.PROD || !('serviceWorker' in navigator)) return
  // Where it is refused, the page needs a network.
  navigator.serviceWorker.register('service-worker.js').catch(() => {})
}
