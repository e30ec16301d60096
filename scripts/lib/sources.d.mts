/** Options of Vite that resolve the workspace's packages to their sources instead of their builds, in browsers and in Node. */
export const SOURCES: {
  resolve: { alias: Record<string, string>; conditions: string[] }
  ssr: { resolve: { conditions: string[] } }
}
