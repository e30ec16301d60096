export function drawRooms(): Promise<string>
