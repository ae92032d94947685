package simgsm.phone;

import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.ObjLongConsumer;
import simgsm.dtmf.ToneExperiment;
import simgsm.phone.handset.Handset;
import simgsm.phone.handset.PhoneKey;
import simgsm.phone.ui.HandsetControls;

/** Carries the window's acts to the handset's thread, and gives the handset time while it wants some. */
final class PhoneControls implements HandsetControls {
    private static final long TICK_MILLIS = 20;
    /** How soon the window tells that a sound device has come or gone. */
    private static final long SOUND_LOOK_SECONDS = 1;

    private final Phone phone;
    private final ScheduledExecutorService ticks = Executors.newSingleThreadScheduledExecutor(act -> {
        Thread thread = new Thread(act, "ticks");
        thread.setDaemon(true);
        return thread;
    });
    /** Owner thread only. */
    private boolean ticking;

    PhoneControls(Phone phone) {
        this.phone = phone;
        phone.execute(() -> {
            phone.handset().whenTimeIsWanted(this::tickWhileWanted);
            tickWhileWanted();
        });
        ticks.scheduleAtFixedRate(
                () -> phone.execute(phone.handset()::lookAtSound), 1, SOUND_LOOK_SECONDS, TimeUnit.SECONDS);
    }

    @Override
    public void keyDown(PhoneKey key) {
        act((handset, now) -> handset.keyDown(key, now));
    }

    @Override
    public void keyUp(PhoneKey key) {
        act((handset, now) -> handset.keyUp(key, now));
    }

    @Override
    public void enterDown() {
        act(Handset::enterDown);
    }

    @Override
    public void enterUp() {
        act(Handset::enterUp);
    }

    @Override
    public void charDown(char character) {
        act((handset, now) -> handset.charDown(character, now));
    }

    @Override
    public void charUp(char character) {
        act((handset, now) -> handset.charUp(character, now));
    }

    @Override
    public void tryOut(ToneExperiment experiment) {
        act((handset, now) -> handset.tryOut(experiment));
    }

    private void act(ObjLongConsumer<Handset> deed) {
        phone.execute(() -> {
            deed.accept(phone.handset(), System.nanoTime());
            tickWhileWanted();
        });
    }

    private void tickWhileWanted() {
        if (!ticking && phone.handset().wantsTime()) {
            ticking = true;
            ticks.schedule(() -> phone.execute(this::tick), TICK_MILLIS, TimeUnit.MILLISECONDS);
        }
    }

    private void tick() {
        ticking = false;
        phone.handset().timePassed(System.nanoTime());
        tickWhileWanted();
    }
}
