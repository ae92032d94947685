package simgsm.station.mobility;

import java.util.EnumSet;
import java.util.Set;
import simgsm.air.RejectCause;

/** Reject causes after which a mobile makes no further attempt in the area (TS 24.008, 4.4.4.7). */
final class FinalCauses {
    /** Without ILLEGAL_MS: on a link to our own centre it means that the number is in use, which may pass. */
    private static final Set<RejectCause> ON_LINK =
            EnumSet.of(RejectCause.IMSI_UNKNOWN_IN_HLR, RejectCause.ILLEGAL_ME, RejectCause.PLMN_NOT_ALLOWED);

    private static final Set<RejectCause> INVALID_SIM =
            EnumSet.of(RejectCause.IMSI_UNKNOWN_IN_HLR, RejectCause.ILLEGAL_MS, RejectCause.ILLEGAL_ME);

    private static final Set<RejectCause> AREA_REFUSED = EnumSet.of(
            RejectCause.PLMN_NOT_ALLOWED,
            RejectCause.LOCATION_AREA_NOT_ALLOWED,
            RejectCause.ROAMING_NOT_ALLOWED,
            RejectCause.NO_SUITABLE_CELLS);

    private FinalCauses() {}

    static boolean contain(RejectCause cause, boolean isOverTowers) {
        return isOverTowers ? invalidateSim(cause) || AREA_REFUSED.contains(cause) : ON_LINK.contains(cause);
    }

    /** True if, over towers, the SIM is invalid until the mobile is switched off. */
    static boolean invalidateSim(RejectCause cause) {
        return INVALID_SIM.contains(cause);
    }
}
