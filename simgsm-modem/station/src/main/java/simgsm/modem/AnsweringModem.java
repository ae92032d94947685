package simgsm.modem;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.station.StationSnapshot;
import simgsm.station.context.StationEvent;

/**
 * The modem of a robot: {@link Modem} (M2), or a real one. It answers calls, reports keys and short messages as
 * {@link StationEvent}s, and sends reply tones and messages. One owner thread calls everything except {@link
 * #snapshot} and {@link #state}.
 */
public interface AnsweringModem {
    /** Makes a modem with a rule for its calls and a listener. */
    interface Maker<M extends AnsweringModem> {
        /**
         * Called once.
         *
         * @param admission rules on a call when it is answered, by the caller's number, empty if the network does not
         *     send it
         * @param listener receives the events; for a denied call only ringing and release
         */
        M make(Function<Optional<Msisdn>, CallDecision> admission, Consumer<StationEvent> listener);
    }

    /** The newest state; callable on any thread. */
    StationSnapshot snapshot();

    /** The newest state in words; callable on any thread. */
    default ModemEvent.StateChanged state() {
        StationSnapshot newest = snapshot();
        ModemState state = switch (newest.card().state()) {
            case READY -> newest.registered() ? ModemState.READY : ModemState.NO_NETWORK;
            case PIN -> ModemState.SIM_PIN;
            case PUK, BLOCKED -> ModemState.SIM_PUK;
        };
        return new ModemEvent.StateChanged(state, newest.networkName());
    }

    /** Queues a reply tone. @return false if there is no accepted and connected call */
    boolean sendTone(DtmfKey key);

    /**
     * Says a reply in words after its tone; a key ends them. @return false if there is no such call, or the modem has no
     * prompts
     */
    default boolean say(String reply) {
        return false;
    }

    /** True if the modem takes orders by voice; callable on any thread. */
    default boolean listensToVoice() {
        return false;
    }

    /** Listens for an order by voice in the accepted call, if it takes any. */
    default void listen() {}

    /**
     * Sends a short message; without service or in a congested network it is repeated for 10 minutes before it fails.
     *
     * @return the message's id
     */
    int reply(Msisdn to, String text);

    /**
     * True if the network has begun a USSD dialogue and waits for the reply; a dialogue of an AT client is the
     * client's.
     */
    default boolean isAskedByNetwork() {
        return false;
    }

    /** Replies to a USSD question of the network. @return false if none is open, or the modem knows no USSD */
    default boolean replyUssd(String text) {
        return false;
    }

    /** Sets that an order is being executed, which stops the count of 60 s without a key. */
    void setOrderUnderWay(boolean active);

    /** Ends the call with cause 16. @return false if there is none */
    boolean hangUp();
}
