package simgsm.tools.load;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import simgsm.air.Cause;
import simgsm.air.RpCause;
import simgsm.station.StationThread;

/**
 * A load run, one kind of load after the other, so that each is measured by itself: the stations attach; they send short
 * messages round the circle; pairs of them call each other and talk. All stations live on one thread.
 */
public final class LoadRun implements LoadPhone.Host {
    /** Under way at the same time; a centre's port holds back more than a thousand who knock at once. */
    private static final int ATTACHING = 200;

    private static final int SENDING = 100;
    private static final int CALLING = 50;
    /** With nothing getting on for so long, it never will. */
    private static final long PATIENCE_NANOS = TimeUnit.SECONDS.toNanos(30);

    /** How long the last speech may be on its way. */
    private static final int LAST_SPEECH_MILLIS = 5_000;

    private static final int POLL_MILLIS = 20;
    /** Speech is counted from so long after the last call stands: what setting them all up at once held up has passed. */
    private static final int SETTLING_MILLIS = 2_000;

    private final LoadPlan plan;
    private final InetSocketAddress center;
    private final List<LoadPhone> phones = new ArrayList<>();
    private final AtomicReference<Throwable> death = new AtomicReference<>();
    private final AtomicReference<String> firstTrouble = new AtomicReference<>();
    private final StationThread stations = new StationThread("load", this::died);
    private final CountDownLatch dead = new CountDownLatch(1);
    private final Window attaching;
    private final MessageRound messages;
    private final Window calling;
    private final Window clearing;
    private final Delays speechDelays = new Delays();
    private volatile boolean isCounting;
    private volatile long framesSent;
    private volatile long framesHeard;

    public LoadRun(LoadPlan plan) {
        this.plan = plan;
        this.center = new InetSocketAddress(plan.center().host(), plan.center().port());
        for (int i = 0; i < plan.phones(); i++) {
            phones.add(new LoadPhone(i, plan.number(i), this));
        }
        attaching = new Window(plan.phones(), ATTACHING, i -> stations.add(phones.get(i).station, center));
        messages = new MessageRound(phones, plan.messages(), SENDING);
        calling = new Window(plan.calls(), CALLING, this::call);
        clearing = new Window(plan.calls(), CALLING, i -> caller(i).station.hangUp());
    }

    private void died(Throwable cause) {
        death.set(cause);
        dead.countDown();
    }

    /** Performs the plan; afterwards no station is left. */
    public LoadResult run() throws InterruptedException {
        stations.start();
        try {
            perform(attaching);
            if (plan.messages() > 0 && attaching.done() == plan.phones()) {
                perform(messages.window());
            }
            talk();
            return result();
        } finally {
            stations.close();
        }
    }

    private void perform(Window window) throws InterruptedException {
        stations.execute(window::start);
        window.await(PATIENCE_NANOS);
        if (death.get() != null) {
            throw new IllegalStateException("the stations have died: " + death.get(), death.get());
        }
    }

    private void talk() throws InterruptedException {
        if (plan.calls() > 0 && attaching.done() == plan.phones()) {
            perform(calling);
            dead.await(SETTLING_MILLIS, TimeUnit.MILLISECONDS);
        }
        isCounting = true;
        dead.await(plan.seconds(), TimeUnit.SECONDS);
        isCounting = false;
        awaitLastSpeech();
        if (calling.done() > 0) {
            perform(clearing);
        }
    }

    private void awaitLastSpeech() throws InterruptedException {
        for (int waited = 0; waited < LAST_SPEECH_MILLIS && framesHeard < framesSent; waited += POLL_MILLIS) {
            dead.await(POLL_MILLIS, TimeUnit.MILLISECONDS);
        }
    }

    private LoadPhone caller(int call) {
        return phones.get(2 * call);
    }

    private LoadPhone called(int call) {
        return phones.get(2 * call + 1);
    }

    private void call(int call) {
        caller(call).talksWith(called(call));
        called(call).talksWith(caller(call));
        if (!caller(call).station.dial(called(call).number())) {
            calling.ended(call, false);
        }
    }

    private void trouble(LoadPhone phone, String what) {
        firstTrouble.compareAndSet(null, phone.number() + ": " + what);
    }

    @Override
    public void attached(LoadPhone phone) {
        attaching.ended(phone.index, true);
    }

    @Override
    public void refused(LoadPhone phone, String reason) {
        trouble(phone, reason);
    }

    /** The called side is connected first: when the caller is, both are. */
    @Override
    public void connected(LoadPhone phone) {
        if (phone.index % 2 == 0) {
            calling.ended(phone.index / 2, true);
        }
    }

    @Override
    public void released(LoadPhone phone, Cause cause) {
        int call = phone.index / 2;
        if (phone.index % 2 == 0) {
            calling.ended(call, false);
            clearing.ended(call, true);
        }
        if (cause != Cause.NORMAL_CALL_CLEARING) {
            trouble(phone, cause.toString());
        }
    }

    @Override
    public void messageArrived(String text) {
        messages.arrived(text);
    }

    @Override
    public void messageFailed(int id, LoadPhone from, RpCause cause) {
        trouble(from, cause.toString());
    }

    @Override
    public boolean isCounting() {
        return isCounting;
    }

    // One thread writes these counts; others only look.

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
                framesSent,
                framesSent - framesHeard,
                speechDelays,
                messages.window(),
                messages.delays(),
                Optional.ofNullable(firstTrouble.get()));
    }
}
