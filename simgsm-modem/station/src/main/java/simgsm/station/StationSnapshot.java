package simgsm.station;

import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.speech.SpeechCodec;

/**
 * A station as others see it, immutable.
 *
 * @param linkUp whether there is a connection to the centre
 * @param rejectCause why the network refused registration, if it did
 * @param cardRefused whether that was because the card could not prove itself
 * @param networkName the operator's name for the display, empty until the network tells it
 * @param peer the other party of the present call, if there is one and its number is known
 * @param codec of the speech that the station sends
 * @param heardCodec of the far end's newest speech in the present call, empty until some has come
 */
public record StationSnapshot(
        boolean powered,
        boolean linkUp,
        boolean registered,
        Optional<RejectCause> rejectCause,
        boolean cardRefused,
        String networkName,
        MobileCallState callState,
        Optional<Msisdn> peer,
        SpeechCodec.Kind codec,
        Optional<SpeechCodec.Kind> heardCodec) {}
