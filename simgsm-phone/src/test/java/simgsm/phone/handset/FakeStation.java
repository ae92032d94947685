package simgsm.phone.handset;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import simgsm.air.Cause;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.air.RpCause;
import simgsm.dtmf.DtmfKey;
import simgsm.octets.OctetString;
import simgsm.sim.PinLock;
import simgsm.sms.ChannelList;
import simgsm.speech.SpeechCodec;
import simgsm.station.StationCommands;
import simgsm.station.StationSnapshot;
import simgsm.station.call.MobileCallTable.MobileCallState;
import simgsm.station.context.StationEvent;
import simgsm.station.context.StationIdentity;

/** A station that does at once what a real one does in the end, and remembers what it was asked. */
public final class FakeStation implements StationCommands {
    /** What was asked, in order. */
    public final List<String> asked = new ArrayList<>();

    /** How the far end's speech is coded. */
    public Optional<SpeechCodec.Kind> heardCodec = Optional.empty();

    /** Whether a message fails before its submission returns. */
    public boolean failsAtOnce;

    /** The card's lock. */
    public PinLock card = PinLock.none();

    private boolean powered = true;
    private boolean inCall;
    private boolean ringing;
    private int nextId;
    private Consumer<StationEvent> listener;

    public void reportTo(Consumer<StationEvent> newListener) {
        listener = newListener;
    }

    /** A call comes in. */
    public void ring(String from) {
        ringing = true;
        inCall = true;
        listener.accept(new StationEvent.Ringing(Optional.of(new Msisdn(from))));
    }

    /** The far end clears, or the network does. */
    public void release(Cause cause) {
        inCall = false;
        ringing = false;
        listener.accept(new StationEvent.Released(cause));
    }

    @Override
    public PinLock.Result useCard(Function<PinLock, PinLock.Result> command) {
        return command.apply(card);
    }

    @Override
    public StationIdentity identity() {
        return StationIdentity.ofOpenNumber(new Msisdn("5550100"), new Imei("490154203237518"), "SimGSM phone");
    }

    @Override
    public boolean dial(Msisdn number) {
        asked.add("dial " + number);
        if (inCall || !powered) {
            return false;
        }
        inCall = true;
        listener.accept(new StationEvent.Calling(number));
        return true;
    }

    @Override
    public void hideNumber(boolean hides) {
        if (hides) {
            asked.add("hide number");
        }
    }

    @Override
    public boolean answer() {
        asked.add("answer");
        if (!ringing) {
            return false;
        }
        ringing = false;
        listener.accept(new StationEvent.Connected(Optional.of(new Msisdn("5550200"))));
        return true;
    }

    @Override
    public boolean hangUp() {
        asked.add("hangUp");
        if (!inCall) {
            return false;
        }
        release(Cause.NORMAL_CALL_CLEARING);
        return true;
    }

    @Override
    public void signalKey(DtmfKey key, int millis) {
        asked.add("signal " + key.symbol() + " " + millis);
    }

    @Override
    public void holdKey(DtmfKey key) {
        asked.add("hold " + key.symbol());
    }

    @Override
    public void releaseKey() {
        asked.add("let go");
    }

    @Override
    public int sendMessage(Msisdn to, String text) {
        asked.add("sms " + to + " " + text);
        if (failsAtOnce) {
            listener.accept(new StationEvent.MessageFailed(nextId, to, RpCause.CONGESTION));
        }
        return nextId++;
    }

    @Override
    public boolean sendUssd(String text) {
        asked.add("ussd " + text);
        return true;
    }

    @Override
    public boolean endUssd() {
        asked.add("end ussd");
        return false;
    }

    @Override
    public int submit(OctetString tpdu, Msisdn to, Msisdn serviceCenter) {
        return nextId++;
    }

    @Override
    public boolean rejectWaiting() {
        asked.add("reject");
        return true;
    }

    @Override
    public boolean hold() {
        asked.add("hold");
        return true;
    }

    @Override
    public void setMemoryAvailable(boolean available) {
        asked.add(available ? "memory free" : "memory full");
    }

    @Override
    public void setChannels(ChannelList channels) {
        asked.add("channels " + channels);
    }

    @Override
    public void setCodec(SpeechCodec.Kind codec) {
        asked.add("codec " + codec);
    }

    @Override
    public void powerOn() {
        powered = true;
        listener.accept(new StationEvent.StationChanged());
    }

    @Override
    public void powerOff() {
        powered = false;
        listener.accept(new StationEvent.StationChanged());
    }

    @Override
    public StationSnapshot snapshot() {
        return new StationSnapshot(
                powered,
                true,
                powered && card.status().isReady(),
                Optional.empty(),
                false,
                "SIMGSM",
                MobileCallState.NULL,
                Optional.empty(),
                Optional.of(SpeechCodec.Kind.A_LAW),
                heardCodec,
                Optional.empty(),
                card.status());
    }
}
