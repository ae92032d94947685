package simgsm.center.msc;

import java.util.concurrent.TimeUnit;
import simgsm.abis.IpaFrame;
import simgsm.abis.RtpPacket;
import simgsm.dtmf.CadencePlayer;
import simgsm.dtmf.ToneCadence;
import simgsm.speech.SpeechCodec;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * Lets a mobile hear a call-progress tone, a frame of A-law every 20 ms, as a stream of its own. Its pauses are frames of
 * silence, so that the mobile need not wonder whether anybody is still there.
 */
final class ProgressSender {
    private static final long FRAME_NANOS = TimeUnit.MILLISECONDS.toNanos(20);
    private static final long NANOS_PER_SAMPLE = 125_000;
    /** Whose stream it is: "prog". */
    private static final int SOURCE = 0x70726f67;

    private final Link link;
    private final Timers timers;
    private final SpeechCodec codec = SpeechCodec.Kind.A_LAW.open();
    private final CadencePlayer player = new CadencePlayer();
    private Timer next;
    private int sequence;
    private int timestamp;

    ProgressSender(Link link, Timers timers) {
        this.link = link;
        this.timers = timers;
        this.timestamp = (int) (timers.nowNanos() / NANOS_PER_SAMPLE);
    }

    void play(ToneCadence tone) {
        stop();
        player.start(tone);
        frameDue();
    }

    void stop() {
        timers.cancel(next);
        player.stop();
    }

    private void frameDue() {
        next = timers.start(FRAME_NANOS, this::frameDue);
        short[] samples = new short[SpeechCodec.SAMPLES_PER_FRAME];
        player.addTo(samples);
        RtpPacket packet = new RtpPacket(
                RtpPacket.A_LAW, sequence++ & 0xffff, Integer.toUnsignedLong(timestamp), SOURCE, codec.encode(samples));
        timestamp += SpeechCodec.SAMPLES_PER_FRAME;
        link.port.send(new IpaFrame(IpaFrame.SPEECH, packet.encode()));
    }
}
