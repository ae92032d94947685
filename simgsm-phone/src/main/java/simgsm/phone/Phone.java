package simgsm.phone;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.time.InstantSource;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Function;
import simgsm.console.FatalError;
import simgsm.phone.handset.Handset;
import simgsm.phone.handset.HandsetListener;
import simgsm.phone.handset.StationSide;
import simgsm.speech.AudioOutput;
import simgsm.speech.CallAudioListener;
import simgsm.speech.CallRecorder;
import simgsm.station.MobileStation;
import simgsm.station.StationOptions;
import simgsm.station.StationThread;

/** A phone at work: handset, station and the thread that owns both. */
final class Phone implements HandsetAccess, AutoCloseable {
    /** An act takes microseconds; if it takes this long the thread has ended. */
    private static final long ACT_SECONDS = 5;

    private final StationThread thread = new StationThread("station", cause -> FatalError.end(PhoneMain.NAME, cause));
    private final AudioOutput output;
    private final CallAudioListener recorder;
    private final Handset handset;
    private final MobileStation station;

    /** @throws IOException if its calls are to be recorded where nothing can be written */
    Phone(PhoneSettings settings, HandsetListener listener, AudioOutput output) throws IOException {
        this.output = output;
        recorder = settings.recording().isPresent()
                ? CallRecorder.open(settings.recording().get())
                : CallAudioListener.NONE;
        handset = new Handset(
                settings.identity().number(),
                settings.keyMode(),
                settings.tones(),
                listener,
                output,
                InstantSource.system());
        station = new MobileStation(
                settings.identity(),
                settings.sim(),
                new StationOptions(settings.codec(), recorder),
                handset.mouth(),
                handset.ears());
        handset.attach(StationSide.of(station));
        handset.wantBroadcasts(settings.channels());
    }

    /** Begins to look for the centre. */
    void start(InetSocketAddress center) {
        thread.add(station, center);
        thread.start();
    }

    /** For its snapshots only; everything else goes through {@link #execute}. */
    Handset handset() {
        return handset;
    }

    /** Has the owner thread do something. */
    void execute(Runnable act) {
        thread.execute(act);
    }

    @Override
    public <T> T ask(Function<Handset, T> act) throws InterruptedException {
        CompletableFuture<T> result = new CompletableFuture<>();
        thread.execute(() -> {
            try {
                result.complete(act.apply(handset));
            } catch (RuntimeException e) {
                result.completeExceptionally(e);
            }
        });
        try {
            return result.get(ACT_SECONDS, TimeUnit.SECONDS);
        } catch (ExecutionException | TimeoutException e) {
            throw new IllegalStateException("the phone did not do it: " + e.getMessage(), e);
        }
    }

    @Override
    public void settle(long boundNanos) throws InterruptedException {
        CompletableFuture<Boolean> settled = new CompletableFuture<>();
        thread.execute(() -> handset.whenSettled(() -> settled.complete(true)));
        try {
            settled.get(boundNanos, TimeUnit.NANOSECONDS);
        } catch (TimeoutException late) {
            // What the network does not take in time stays undone.
        } catch (ExecutionException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    /** Hangs up, detaches, ends the thread. */
    @Override
    public void close() {
        thread.close();
        recorder.close();
        output.close();
    }
}
