package simgsm.center.msc.ss;

import static simgsm.center.msc.ss.UssdDialogueTable.UssdAction.*;
import static simgsm.center.msc.ss.UssdDialogueTable.UssdEvent.*;
import static simgsm.center.msc.ss.UssdDialogueTable.UssdState.*;

import java.util.EnumSet;
import java.util.Set;
import simgsm.state.StateTable;

/** One USSD dialogue on the network side (TS 24.090): begun by the mobile in IN_SERVICE, by the network in PAGING. */
public final class UssdDialogueTable {
    /** States. */
    public enum UssdState {
        /** The mobile is being paged. */
        PAGING,
        /** A service of the network is working. */
        IN_SERVICE,
        /** The question is sent to the mobile. */
        WAIT_FOR_REPLY,
        ENDED
    }

    /** Events. */
    public enum UssdEvent {
        RADIO_CONNECTED,
        PAGING_FAILED,
        /** The service asks the user of a dialogue that the mobile began. */
        SERVICE_ASKS,
        /** The service ends the dialogue, with or without an answer. */
        SERVICE_ENDS,
        /** The result of the question. */
        REPLIED,
        /** The error of the question, or its rejection. */
        REPLY_REFUSED,
        REPLY_EXPIRED,
        /** RELEASE COMPLETE of the mobile. */
        MOBILE_ENDS,
        RADIO_LOST
    }

    /** Actions. */
    public enum UssdAction {
        SEND_REGISTER,
        SEND_FACILITY,
        SEND_RELEASE_COMPLETE,
        START_REPLY_TIMER,
        STOP_REPLY_TIMER,
        /** Passes the reply to the service. */
        TELL_REPLY,
        /** Reports the question's failure to the service that began the dialogue. */
        TELL_FAILURE,
        END
    }

    private static final Set<UssdState> OPEN = EnumSet.of(IN_SERVICE, WAIT_FOR_REPLY);

    public static final StateTable<UssdState, UssdEvent, UssdAction> ROWS = new StateTable<
                    UssdState, UssdEvent, UssdAction>("USSD dialogue", PAGING)
            .on(PAGING, RADIO_CONNECTED, WAIT_FOR_REPLY, SEND_REGISTER, START_REPLY_TIMER)
            .on(EnumSet.of(PAGING), EnumSet.of(PAGING_FAILED, RADIO_LOST), ENDED, TELL_FAILURE, END)
            .on(IN_SERVICE, SERVICE_ASKS, WAIT_FOR_REPLY, SEND_FACILITY, START_REPLY_TIMER)
            .on(IN_SERVICE, SERVICE_ENDS, ENDED, SEND_RELEASE_COMPLETE, END)
            .on(WAIT_FOR_REPLY, REPLIED, IN_SERVICE, STOP_REPLY_TIMER, TELL_REPLY)
            .on(
                    EnumSet.of(WAIT_FOR_REPLY),
                    EnumSet.of(REPLY_REFUSED, REPLY_EXPIRED),
                    ENDED,
                    STOP_REPLY_TIMER,
                    SEND_RELEASE_COMPLETE,
                    TELL_FAILURE,
                    END)
            .on(OPEN, EnumSet.of(MOBILE_ENDS, RADIO_LOST), ENDED, STOP_REPLY_TIMER, TELL_FAILURE, END);

    private UssdDialogueTable() {}
}
