// The picture of the replay with what it shows written below, as a PNG.

const kLine = 20; // [px]

export function pictureOf(canvas: HTMLCanvasElement, lines: string[], dark: boolean): Promise<Blob> {
  const scale = canvas.width / Math.max(1, canvas.clientWidth || canvas.width);
  const foot = Math.round((lines.length * kLine + 12) * scale);
  const copy = document.createElement("canvas");
  copy.width = canvas.width;
  copy.height = canvas.height + foot;
  const pen = copy.getContext("2d");
  if (!pen) return Promise.reject(new Error("This browser makes no pictures of a canvas."));
  pen.fillStyle = dark ? "#161b21" : "#ffffff";
  pen.fillRect(0, 0, copy.width, copy.height);
  pen.drawImage(canvas, 0, 0);
  pen.fillStyle = dark ? "#e6e9ec" : "#1c2126";
  pen.font = `${13 * scale}px sans-serif`;
  lines.forEach((line, i) => pen.fillText(line, 10 * scale, canvas.height + (kLine * (i + 1) - 3) * scale, copy.width - 20 * scale));
  return new Promise((resolve, reject) => {
    copy.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("The picture could not be made."))), "image/png");
  });
}

export function download(blob: Blob, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
