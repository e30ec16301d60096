/** Serves the built site as any server of files would, under a path of its own. */
export function serveSite(): Promise<{ address: string; close(): Promise<void> }>
