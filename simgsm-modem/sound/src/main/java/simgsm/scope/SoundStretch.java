package simgsm.scope;

import java.util.ArrayList;
import java.util.List;

/** The last stretch of a sound, immutable: up to {@link #SAMPLES}, in memory shared with earlier stretches. */
public final class SoundStretch {
    /** 2 s at 8 kHz. */
    public static final int SAMPLES = 16_000;

    static final SoundStretch EMPTY = new SoundStretch(List.of());

    private final List<short[]> frames;
    private final int length;

    private SoundStretch(List<short[]> frames) {
        this.frames = frames;
        this.length = frames.stream().mapToInt(frame -> frame.length).sum();
    }

    /**
     * A copy with a frame appended, which must not change afterwards; samples older than {@link #SAMPLES} are
     * dropped.
     */
    SoundStretch with(short[] frame) {
        int from = 0;
        int kept = length + frame.length;
        while (from < frames.size() && kept - frames.get(from).length >= SAMPLES) {
            kept -= frames.get(from).length;
            from++;
        }
        List<short[]> all = new ArrayList<>(frames.size() - from + 1);
        all.addAll(frames.subList(from, frames.size()));
        all.add(frame);
        return new SoundStretch(all);
    }

    /** The last samples, oldest first, padded with silence. */
    public short[] last(int count) {
        short[] samples = new short[count];
        int end = count;
        for (int i = frames.size() - 1; i >= 0 && end > 0; i--) {
            short[] frame = frames.get(i);
            int part = Math.min(end, frame.length);
            System.arraycopy(frame, frame.length - part, samples, end - part, part);
            end -= part;
        }
        return samples;
    }
}
