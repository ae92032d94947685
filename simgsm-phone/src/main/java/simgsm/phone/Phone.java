package simgsm.phone;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetSocketAddress;
import java.time.InstantSource;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import java.util.function.Function;
import simgsm.console.FatalError;
import simgsm.modem.at.AtProfile;
import simgsm.modem.at.command.AtModem;
import simgsm.modem.at.port.AtPort;
import simgsm.phone.handset.Handset;
import simgsm.sim.SimPhoneBook;
import simgsm.speech.AudioInput;
import simgsm.speech.AudioOutput;
import simgsm.speech.CallAudioListener;
import simgsm.speech.CallRecorder;
import simgsm.station.MobileStation;
import simgsm.station.StationOptions;
import simgsm.station.StationThread;
import simgsm.station.context.StationEvent;

/** A running phone: handset, station and the thread that owns both. */
final class Phone implements HandsetAccess, AutoCloseable {
    private static final System.Logger LOG = System.getLogger(Phone.class.getName());
    /** Time-out of an action, which takes microseconds; the thread is taken to have ended then. */
    private static final long ANSWER_SECONDS = 5;

    private final StationThread thread = new StationThread("station", cause -> FatalError.end(PhoneMain.NAME, cause));
    private final SimPhoneBook phoneBook = new SimPhoneBook();
    private final AudioOutput output;
    private final AudioInput microphone;
    private final CallAudioListener recorder;
    private final Handset handset;
    private final MobileStation station;
    private final Optional<PhoneData> data;
    private Optional<AtPort> at = Optional.empty();

    /** @throws IOException if the recording's file cannot be written, or the stored data cannot be read */
    Phone(PhoneOptions options, Consumer<StationEvent> listener, AudioOutput output, AudioInput microphone)
            throws IOException {
        this.output = output;
        this.microphone = microphone;
        recorder = options.recording().isPresent()
                ? CallRecorder.open(options.recording().get())
                : CallAudioListener.NONE;
        handset = new Handset(
                options.identity().number(),
                options.user(),
                options.tones(),
                phoneBook,
                listener,
                output,
                InstantSource.system());
        station = new MobileStation(
                options.identity(),
                options.sim(),
                new StationOptions(options.user().codec(), recorder, true, options.ignoresSetup()),
                handset::fillFrame,
                this::accept);
        handset.attach(station);
        handset.setMicrophone(microphone);
        station.setChannels(options.channels());
        data = options.data().isPresent()
                ? Optional.of(
                        PhoneData.take(options.data().get(), options.identity().number()))
                : Optional.empty();
        if (data.isPresent()) {
            Map<String, String> kept = new TreeMap<>(data.get().read());
            kept.keySet().removeAll(options.given());
            handset.restore(kept)
                    .forEach(key -> LOG.log(Level.WARNING, "--data: {0} is not understood and left out", key));
            handset.keepBy(data.get()::write);
        }
    }

    private void accept(StationEvent event) {
        handset.accept(event);
        at.ifPresent(port -> port.accept(event));
    }

    /** Opens a port for AT commands, before the start. */
    AtPort openAtPort(InetSocketAddress address, AtProfile profile) throws IOException {
        AtModem modem = new AtModem(new PhoneTerminal(handset, station, phoneBook), profile, InstantSource.system());
        AtPort port = AtPort.open(modem, station, thread, address);
        at = Optional.of(port);
        return port;
    }

    /** Connects to the centre and retries until it succeeds. */
    void start(InetSocketAddress center) {
        thread.add(station, center);
        thread.start();
        at.ifPresent(AtPort::exchangeFirst);
    }

    /** The handset: its snapshot may be read on any thread, all else runs through {@link #execute}. */
    Handset handset() {
        return handset;
    }

    /** Runs an action on the owner thread. */
    void execute(Runnable action) {
        thread.execute(action);
    }

    @Override
    public <T> T ask(Function<Handset, T> action) throws InterruptedException {
        FutureTask<T> task = new FutureTask<>(() -> action.apply(handset));
        thread.execute(task);
        try {
            return task.get(ANSWER_SECONDS, TimeUnit.SECONDS);
        } catch (TimeoutException e) {
            throw new IllegalStateException("the phone has not answered within " + ANSWER_SECONDS + " s", e);
        } catch (ExecutionException e) {
            throw new IllegalStateException("the phone has failed: " + e.getCause(), e);
        }
    }

    @Override
    public boolean settle(long limitNanos) throws InterruptedException {
        CountDownLatch settled = new CountDownLatch(1);
        thread.execute(() -> handset.whenSettled(settled::countDown));
        boolean isSettled = settled.await(limitNanos, TimeUnit.NANOSECONDS);
        if (!isSettled) {
            LOG.log(Level.WARNING, "the network has not acknowledged everything");
        }
        return isSettled;
    }

    /** Ends the call, detaches and ends the thread. */
    @Override
    public void close() {
        thread.close();
        data.ifPresent(PhoneData::close);
        recorder.close();
        output.close();
        microphone.close();
    }
}
