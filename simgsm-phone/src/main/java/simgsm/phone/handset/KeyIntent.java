package simgsm.phone.handset;

import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;

/** What a pressed key asks the handset to do, beyond changing the screen. */
sealed interface KeyIntent {
    /** An intent without a parameter. */
    enum Simple implements KeyIntent {
        NOTHING,
        ANSWER,
        END_USSD,
        SWITCH_OFF
    }

    /** To the far end in a call, else at the earpiece only. */
    record PlayTone(DtmfKey tone) implements KeyIntent {}

    /** @param text as typed, perhaps no number */
    record DialText(String text) implements KeyIntent {}

    /** The reply to the network's question. */
    record ReplyUssd(String text) implements KeyIntent {}

    /** @param replaced the failed message that is sent again */
    record SendText(Msisdn to, String text, Optional<StoredMessage> replaced) implements KeyIntent {}
}
