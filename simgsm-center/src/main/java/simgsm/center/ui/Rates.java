package simgsm.center.ui;

import simgsm.center.msc.ExchangeSnapshot;

/** Messages and speech frames per second, from the counts at two times. */
final class Rates {
    private static final double NANOS_PER_SECOND = 1e9;

    private long messages;
    private long frames;
    private long measuredMessages;
    private long measuredFrames;
    private long measuredNanos;
    private boolean isMeasured;
    private long messagesPerSecond;
    private long framesPerSecond;

    /** Stores the current counts. */
    void saw(ExchangeSnapshot snapshot) {
        messages = snapshot.ladderCount();
        frames = snapshot.speechFrames();
    }

    /** Measures from the last tick to this one. */
    void tick(long nowNanos) {
        double seconds = (nowNanos - measuredNanos) / NANOS_PER_SECOND;
        if (isMeasured && seconds > 0) {
            messagesPerSecond = Math.round((messages - measuredMessages) / seconds);
            framesPerSecond = Math.round((frames - measuredFrames) / seconds);
        }
        isMeasured = true;
        measuredNanos = nowNanos;
        measuredMessages = messages;
        measuredFrames = frames;
    }

    long messagesPerSecond() {
        return messagesPerSecond;
    }

    long framesPerSecond() {
        return framesPerSecond;
    }
}
