package simgsm.tools.load;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import simgsm.air.Cause;
import simgsm.air.RpCause;
import simgsm.station.StationThread;

/**
 * Performs a load; each kind of load is measured alone: the stations attach; each sends short messages to the
 * next; pairs of them hold calls. All stations run on one thread.
 */
public final class LoadGenerator implements LoadStation.Observer {
    /** Connections being opened at a time; the backlog of a centre's port holds about 1000. */
    private static final int ATTACHING = 200;

    private static final int SENDING = 100;
    private static final int CALLING = 50;
    /** Time-out without progress. */
    private static final long TIMEOUT_NANOS = TimeUnit.SECONDS.toNanos(30);

    /** Longest wait for the last speech frames. */
    private static final int LAST_SPEECH_MILLIS = 5_000;

    private static final int POLL_MILLIS = 20;
    /** From the last call's connection to the counting of speech, which the set-up of the calls would delay. */
    private static final int SETTLING_MILLIS = 2_000;

    private final LoadOptions options;
    private final InetSocketAddress center;
    private final List<LoadStation> phones = new ArrayList<>();
    private final AtomicReference<Throwable> failure = new AtomicReference<>();
    private final AtomicReference<String> firstError = new AtomicReference<>();
    private final StationThread stations = new StationThread("load", this::failed);
    private final CountDownLatch ended = new CountDownLatch(1);
    private final TaskWindow attaching;
    private final MessageLoad messages;
    private final TaskWindow calling;
    private final TaskWindow clearing;
    private final DelayHistogram speechDelays = new DelayHistogram();
    /** The connected calls; owned by the stations' thread. */
    private final BitSet held = new BitSet();

    private boolean isClearing;
    private volatile int callsLost;
    private volatile boolean isCounting;
    private volatile long framesSent;
    private volatile long framesHeard;

    public LoadGenerator(LoadOptions options) {
        this.options = options;
        this.center =
                new InetSocketAddress(options.center().host(), options.center().port());
        long answerAfterNanos = TimeUnit.MILLISECONDS.toNanos(options.answerAfterMillis());
        for (int i = 0; i < options.phones(); i++) {
            phones.add(new LoadStation(i, options.number(i), answerAfterNanos, this));
        }
        attaching = new TaskWindow(options.phones(), ATTACHING, i -> stations.add(phones.get(i).station, center));
        messages = new MessageLoad(phones, options.messages(), SENDING);
        calling = new TaskWindow(options.calls(), CALLING, this::call);
        clearing = new TaskWindow(options.calls(), CALLING, this::clear);
    }

    private void failed(Throwable cause) {
        failure.set(cause);
        ended.countDown();
    }

    /** Performs the load and detaches all stations. */
    public LoadResult run() throws InterruptedException {
        stations.start();
        try {
            perform(attaching);
            if (options.messages() > 0 && attaching.done() == options.phones()) {
                perform(messages.window());
            }
            holdCalls();
            return result();
        } finally {
            stations.close();
        }
    }

    private void perform(TaskWindow window) throws InterruptedException {
        stations.execute(window::start);
        window.await(TIMEOUT_NANOS);
        if (failure.get() != null) {
            throw new IllegalStateException("the stations' thread has ended: " + failure.get(), failure.get());
        }
    }

    private void holdCalls() throws InterruptedException {
        if (options.calls() > 0 && attaching.done() == options.phones()) {
            perform(calling);
            ended.await(SETTLING_MILLIS, TimeUnit.MILLISECONDS);
        }
        isCounting = true;
        ended.await(options.seconds(), TimeUnit.SECONDS);
        isCounting = false;
        awaitLastSpeech();
        if (calling.done() > 0) {
            stations.execute(() -> isClearing = true);
            perform(clearing);
        }
    }

    private void awaitLastSpeech() throws InterruptedException {
        for (int waited = 0; waited < LAST_SPEECH_MILLIS && framesHeard < framesSent; waited += POLL_MILLIS) {
            ended.await(POLL_MILLIS, TimeUnit.MILLISECONDS);
        }
    }

    private LoadStation caller(int call) {
        return phones.get(2 * call);
    }

    private LoadStation called(int call) {
        return phones.get(2 * call + 1);
    }

    private void call(int call) {
        caller(call).setPartner(called(call));
        called(call).setPartner(caller(call));
        if (!caller(call).station.dial(called(call).number())) {
            calling.ended(call, false);
        }
    }

    private void clear(int call) {
        if (held.get(call)) {
            caller(call).station.hangUp();
        } else {
            clearing.ended(call, false);
        }
    }

    private void fail(LoadStation phone, String what) {
        firstError.compareAndSet(null, phone.number() + ": " + what);
    }

    @Override
    public void attached(LoadStation phone) {
        attaching.ended(phone.index, true);
    }

    @Override
    public void refused(LoadStation phone, String reason) {
        fail(phone, reason);
    }

    /** The called side is connected before the caller. */
    @Override
    public void connected(LoadStation phone) {
        if (phone.index % 2 == 0) {
            held.set(phone.index / 2);
            calling.ended(phone.index / 2, true);
        }
    }

    @Override
    public void released(LoadStation phone, Cause cause) {
        int call = phone.index / 2;
        if (phone.index % 2 == 0) {
            if (held.get(call) && !isClearing) {
                callsLost = callsLost + 1;
            }
            held.clear(call);
            calling.ended(call, false);
            clearing.ended(call, true);
        }
        if (cause != Cause.NORMAL_CALL_CLEARING) {
            fail(phone, cause.toString());
        }
    }

    @Override
    public void messageArrived(String text) {
        messages.arrived(text);
    }

    @Override
    public void messageFailed(int id, LoadStation from, RpCause cause) {
        fail(from, cause.toString());
    }

    @Override
    public boolean isCounting() {
        return isCounting;
    }

    // Only the stations' thread writes these counts.

    @Override
    public void spoke() {
        long sent = framesSent;
        framesSent = sent + 1;
    }

    @Override
    public void heard(long nanos) {
        long heard = framesHeard;
        framesHeard = heard + 1;
        speechDelays.add(nanos);
    }

    private LoadResult result() {
        return new LoadResult(
                attaching,
                calling,
                callsLost,
                framesSent,
                framesSent - framesHeard,
                speechDelays,
                messages.window(),
                messages.delays(),
                Optional.ofNullable(firstError.get()));
    }
}
