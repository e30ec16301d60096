/** Serves the built site like a static file server, under an arbitrary path. */
export function serveSite(): Promise<{ address: string; close(): Promise<void> }>
