package simgsm.gateway.sip;

import static simgsm.gateway.sip.SipCallTable.SipCallAction.*;
import static simgsm.gateway.sip.SipCallTable.SipCallEvent.*;
import static simgsm.gateway.sip.SipCallTable.SipCallState.*;

import java.util.EnumSet;
import simgsm.state.StateTable;

/** A call between a SIP phone and its station in the network (RFC 3398, 7 and 8). */
final class SipCallTable {
    /** States. */
    enum SipCallState {
        IDLE,
        /** The phone has sent INVITE, the station SETUP. */
        CALLING,
        /** The network has sent SETUP, the gateway INVITE. */
        RINGING,
        /** The phone has answered; the network has still to connect. */
        ANSWERED,
        ACTIVE,
        /** The network has released before the phone's final response. */
        CANCELLING,
        ENDED
    }

    /** Events of phone and station. */
    enum SipCallEvent {
        INVITED,
        OFFERED,
        ALERTED,
        CONNECTED,
        RELEASED,
        PHONE_ANSWERED,
        PHONE_REFUSED,
        PHONE_CANCELLED,
        /** BYE. */
        PHONE_ENDED,
        /** The phone has not acknowledged 200, or gives no sign. */
        PHONE_LOST
    }

    /** Actions of {@link SipCall}. */
    enum SipCallAction {
        DIAL,
        SEND_RINGING,
        SEND_OK,
        SEND_INVITE,
        SEND_ACK,
        SEND_CANCEL,
        SEND_BYE,
        /** The response for the network's cause. */
        REFUSE_INVITE,
        /** 487. */
        END_INVITE,
        ANSWER_STATION,
        /** Also after the network's release: its tones may still be played. */
        CLEAR_STATION,
        START_SPEECH,
        CLOSE
    }

    static final StateTable<SipCallState, SipCallEvent, SipCallAction> TABLE = new StateTable<>("SIP call", IDLE);

    static {
        TABLE.on(IDLE, INVITED, CALLING, DIAL)
                .stay(EnumSet.of(CALLING), ALERTED, SEND_RINGING)
                .on(CALLING, CONNECTED, ACTIVE, SEND_OK, START_SPEECH)
                .on(CALLING, RELEASED, ENDED, REFUSE_INVITE, CLEAR_STATION, CLOSE)
                .on(
                        EnumSet.of(CALLING),
                        EnumSet.of(PHONE_CANCELLED, PHONE_ENDED, PHONE_LOST),
                        ENDED,
                        END_INVITE,
                        /** Also after the network's release: its tones may still be played. */
                        CLEAR_STATION,
                        CLOSE)
                .on(IDLE, OFFERED, RINGING, SEND_INVITE)
                .on(RINGING, PHONE_ANSWERED, ANSWERED, SEND_ACK, ANSWER_STATION)
                .on(RINGING, PHONE_REFUSED, ENDED, CLEAR_STATION, CLOSE)
                .on(RINGING, RELEASED, CANCELLING, SEND_CANCEL, CLEAR_STATION)
                .on(RINGING, PHONE_LOST, CANCELLING, SEND_CANCEL, CLEAR_STATION)
                .on(CANCELLING, PHONE_ANSWERED, ENDED, SEND_ACK, SEND_BYE, CLOSE)
                .on(CANCELLING, PHONE_REFUSED, ENDED, CLOSE)
                .on(ANSWERED, CONNECTED, ACTIVE, START_SPEECH)
                .stay(EnumSet.of(ANSWERED, ACTIVE, ENDED), PHONE_ANSWERED, SEND_ACK)
                .on(EnumSet.of(ANSWERED, ACTIVE), RELEASED, ENDED, SEND_BYE, CLEAR_STATION, CLOSE)
                .on(EnumSet.of(ANSWERED, ACTIVE), PHONE_ENDED, ENDED, CLEAR_STATION, CLOSE)
                .on(EnumSet.of(ANSWERED, ACTIVE), PHONE_LOST, ENDED, SEND_BYE, CLEAR_STATION, CLOSE);
    }

    private SipCallTable() {}
}
