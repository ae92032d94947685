package simrobot.control;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.LongSupplier;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfDigit;
import simgsm.dtmf.DtmfKey;
import simgsm.modem.AnsweringModem;
import simgsm.modem.CallDecision;
import simgsm.modem.ModemEvent;
import simgsm.scope.ToneTrace;
import simgsm.scope.ToneTracer;
import simgsm.station.context.StationEvent;
import simgsm.tone.ToneExperiment;
import simgsm.words.WordComparison;
import vericommand.ReplyTone;

/**
 * Connects a robot's control with its modem. Modem events arrive on the stations' thread and are posted to the
 * simulation's thread; requests of the control are posted the other way.
 */
final class ModemLink<M extends AnsweringModem> implements ModemPort {
    private static final Logger LOG = System.getLogger(ModemLink.class.getName());
    private static final double NANOS_PER_SAMPLE = 1e9 / 8000;
    /** Samples of a speech frame, 20 ms; a key is decided within the newest frame. */
    private static final long FRAME_SAMPLES = 160;

    /** Replaces a key that could not be read; it fits no order. */
    private static final char UNREADABLE_KEY = '?';

    private final M modem;
    private final Executor stations;
    private final Executor simulation;
    private final LongSupplier clockNanos;
    private final ToneTracer tracer = new ToneTracer();
    private RobotControl control;
    private volatile ToneTrace trace = ToneTrace.EMPTY;

    // owned by the stations' thread
    /** Number of the newest call, from 1; requests for earlier calls are dropped. */
    private long callNumber;

    /** Pending replies by their ids. */
    private final Map<Integer, RobotEvent.ReplyFailed> replies = new HashMap<>();

    private boolean accepted;
    private long heardSamples;
    private int tonesToLeave;
    private boolean clearWhenSilent;

    ModemLink(AnsweringModem.Maker<M> maker, ControlThreads drivers) {
        stations = drivers.stations();
        simulation = drivers.simulation();
        clockNanos = drivers.clockNanos();
        modem = maker.make(this::decide, this::accept);
    }

    /** Sets the control; called once, before the modem has a link. */
    void serve(RobotControl robotControl) {
        control = robotControl;
    }

    M modem() {
        return modem;
    }

    /** Returns the modem's newest state; callable on any thread. */
    RobotEvent.ModemChanged state() {
        ModemEvent.StateChanged newest = modem.state();
        return new RobotEvent.ModemChanged(newest.state(), newest.text());
    }

    /** Returns the newest trace of the received tones; callable on any thread. */
    ToneTrace trace() {
        return trace;
    }

    void tryOut(ToneExperiment experiment) {
        stations.execute(() -> {
            tracer.tryOut(experiment);
            trace = tracer.newest();
        });
    }

    // ---- from the modem, on the stations' thread -------------------------------------------------------------------

    private void accept(StationEvent event) {
        if (event instanceof StationEvent.SpeechReceived speech) {
            tracer.accept(speech.samples());
            trace = tracer.newest();
        } else if (event instanceof ModemEvent ofModem) {
            accept(ofModem);
        } else if (event instanceof StationEvent.StationRegistered registered) {
            RobotEvent reported = new RobotEvent.Registered(registered.number().digits());
            simulation.execute(() -> control.tell(reported));
        } else if (event instanceof StationEvent.StationUnregistered unregistered) {
            String code = unregistered
                    .cause()
                    .map(reject -> Integer.toString(reject.code()))
                    .orElse("");
            simulation.execute(() -> control.tell(new RobotEvent.Unregistered(code)));
        } else if (event instanceof StationEvent.Ringing ringing) {
            String caller = digits(ringing.from());
            simulation.execute(() -> control.tell(new RobotEvent.CallRinging(caller)));
        } else if (event instanceof StationEvent.Connected connected) {
            String caller = digits(connected.peer());
            long number = callNumber;
            simulation.execute(() -> control.callBegan(number, caller));
        } else if (event instanceof StationEvent.Released released) {
            callEnded(released.cause());
        } else if (event instanceof StationEvent.ShortMessageReceived message) {
            simulation.execute(() -> control.message(message.from(), message.text()));
        } else if (event instanceof StationEvent.UssdReceived question && modem.isAskedByNetwork()) {
            simulation.execute(() -> {
                String reply = control.question(question.text());
                stations.execute(() -> modem.replyUssd(reply));
            });
        } else if (event instanceof StationEvent.MessageSent sent) {
            replies.remove(sent.id());
        } else if (event instanceof StationEvent.MessageFailed failed) {
            messageFailed(failed);
        }
    }

    private void messageFailed(StationEvent.MessageFailed failed) {
        LOG.log(
                Level.WARNING,
                "reply SMS to " + failed.to() + " was not taken: cause "
                        + failed.cause().code());
        Optional.ofNullable(replies.remove(failed.id()))
                .ifPresent(reply -> simulation.execute(() -> control.tell(reply)));
    }

    private void accept(ModemEvent event) {
        if (event instanceof ModemEvent.KeyDecided decided) {
            DtmfDigit digit = decided.digit();
            char key = digit.key().symbol();
            if (!digit.isMeasured()) {
                tracer.show(digit);
                trace = tracer.newest();
            }
            long began = clockNanos.getAsLong() - Math.round(samplesSinceStart(digit) * NANOS_PER_SAMPLE);
            simulation.execute(() -> control.key(key, began));
        } else if (event instanceof ModemEvent.KeyEnded) {
            simulation.execute(control::keyEnded);
        } else if (event instanceof ModemEvent.StateChanged) {
            RobotEvent changed = state();
            simulation.execute(() -> control.tell(changed));
        } else if (event instanceof ModemEvent.CallIdle idle) {
            simulation.execute(() -> control.callIdle(idle.seconds()));
        } else if (event instanceof ModemEvent.KeyUnreadable) {
            long now = clockNanos.getAsLong();
            simulation.execute(() -> control.key(UNREADABLE_KEY, now));
        } else if (event instanceof ModemEvent.SpeechProcessed speech) {
            heardSamples += speech.samples();
            simulation.execute(() -> control.speech(speech.samples()));
        } else if (event instanceof ModemEvent.ReplyToneSent sent) {
            simulation.execute(
                    () -> control.tell(new RobotEvent.ToneSent(sent.key().symbol())));
            toneLeft();
        } else if (event instanceof ModemEvent.WordsBegun words) {
            simulation.execute(() -> control.tell(new RobotEvent.Said(words.text())));
        } else if (event instanceof ModemEvent.WordHeard word) {
            wordHeard(word.compared());
        } else if (event instanceof ModemEvent.OrderSpoken order) {
            long now = clockNanos.getAsLong();
            simulation.execute(() -> order.keys().chars().forEach(key -> control.key((char) key, now)));
        } else if (event instanceof ModemEvent.ReplyToneFailed failed) {
            LOG.log(Level.INFO, "tone " + failed.key().symbol() + " was not sent: the modem refuses it");
            toneLeft();
        }
    }

    private void wordHeard(WordComparison compared) {
        tracer.show(compared);
        trace = tracer.newest();
        RobotEvent heard = RobotEvent.WordHeard.of(compared.result());
        simulation.execute(() -> control.tell(heard));
    }

    private void toneLeft() {
        tonesToLeave = Math.max(0, tonesToLeave - 1);
        clearIfSilent();
    }

    private CallDecision decide(Optional<Msisdn> from) {
        String caller = digits(from);
        ReplyTone tone = control.admission(caller);
        callNumber++;
        accepted = tone == ReplyTone.CONNECTION_ACCEPTED;
        heardSamples = 0;
        tonesToLeave = 1;
        clearWhenSilent = false;
        tracer.reset();
        trace = tracer.newest();
        simulation.execute(() -> control.tell(new RobotEvent.CallReceived(caller)));
        return new CallDecision(accepted, DtmfKey.of(tone.key()));
    }

    /**
     * Counts to the end of the current frame, which has arrived whole, after the deciding sample. A key reported by a
     * modem has no frame.
     */
    long samplesSinceStart(DtmfDigit digit) {
        long now = digit.isMeasured() ? heardSamples + FRAME_SAMPLES : digit.decidedAtSample();
        return Math.max(0, now - digit.startedAtSample());
    }

    private void callEnded(Cause cause) {
        tracer.rest();
        trace = tracer.newest();
        accepted = false;
        tonesToLeave = 0;
        clearWhenSilent = false;
        simulation.execute(() -> control.callEnded(cause.code()));
    }

    // ---- to the modem ----------------------------------------------------------------------------------------------

    @Override
    public void sendTone(long call, char key) {
        stations.execute(() -> {
            if (call == callNumber && modem.sendTone(DtmfKey.of(key))) {
                tonesToLeave++;
            }
        });
    }

    @Override
    public void say(long call, String reply) {
        stations.execute(() -> {
            if (call == callNumber) {
                modem.say(reply);
            }
        });
    }

    @Override
    public boolean listen(long call) {
        stations.execute(() -> {
            if (call == callNumber) {
                modem.listen();
            }
        });
        return modem.listensToVoice();
    }

    @Override
    public void clearCall(long call) {
        stations.execute(() -> {
            if (call == callNumber) {
                clearWhenSilent = accepted;
                clearIfSilent();
            }
        });
    }

    private void clearIfSilent() {
        if (clearWhenSilent && tonesToLeave == 0) {
            clearWhenSilent = false;
            modem.hangUp();
        }
    }

    @Override
    public boolean sendMessage(String to, String text) {
        Msisdn number;
        try {
            number = Msisdn.parse(to);
        } catch (IllegalArgumentException notANumber) {
            LOG.log(Level.INFO, "no reply to \"" + to + "\": " + notANumber.getMessage());
            return false;
        }
        stations.execute(() -> replies.put(modem.reply(number, text), new RobotEvent.ReplyFailed(to, text)));
        return true;
    }

    @Override
    public void setOrderUnderWay(boolean underWay) {
        stations.execute(() -> modem.setOrderUnderWay(underWay));
    }

    private static String digits(Optional<Msisdn> number) {
        return number.map(Msisdn::digits).orElse("");
    }
}
