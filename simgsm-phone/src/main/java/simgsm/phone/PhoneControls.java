package simgsm.phone;

import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.ObjLongConsumer;
import simgsm.phone.handset.Handset;
import simgsm.phone.ui.HandsetControls;
import simgsm.thread.DaemonThread;

/**
 * Runs the window's actions on the handset's thread, and passes the time to the handset every 20 ms while needed.
 */
final class PhoneControls implements HandsetControls, AutoCloseable {
    private static final long TICK_MILLIS = 20;
    private static final long SOUND_CHECK_SECONDS = 1;

    private final Phone phone;
    private final ScheduledExecutorService ticks = new ScheduledThreadPoolExecutor(
            1, task -> DaemonThread.of("ticks", task::run), new ThreadPoolExecutor.DiscardPolicy());
    /** Owner thread only. */
    private boolean ticking;

    PhoneControls(Phone phone) {
        this.phone = phone;
        perform((handset, now) -> handset.whenTimeIsWanted(this::tickWhileWanted));
        ticks.scheduleAtFixedRate(
                () -> phone.execute(phone.handset()::checkSoundDevice), 1, SOUND_CHECK_SECONDS, TimeUnit.SECONDS);
    }

    @Override
    public void perform(ObjLongConsumer<Handset> action) {
        phone.execute(() -> {
            action.accept(phone.handset(), System.nanoTime());
            tickWhileWanted();
        });
    }

    private void tickWhileWanted() {
        if (!ticking && phone.handset().wantsTime()) {
            ticking = true;
            ticks.schedule(() -> phone.execute(this::tick), TICK_MILLIS, TimeUnit.MILLISECONDS);
        }
    }

    /** Ends the clock after the window's end. */
    @Override
    public void close() {
        ticks.shutdownNow();
    }

    private void tick() {
        ticking = false;
        phone.handset().timePassed(System.nanoTime());
        tickWhileWanted();
    }
}
