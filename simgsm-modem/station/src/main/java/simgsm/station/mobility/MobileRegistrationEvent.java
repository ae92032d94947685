package simgsm.station.mobility;

/** Events of {@link MobileRegistrationTable}. */
public enum MobileRegistrationEvent {
    POWER_ON,
    POWER_OFF,
    CELL_FOUND,
    LINK_LOST,
    LOCATION_UPDATING_ACCEPTED,
    LOCATION_UPDATING_REJECTED,
    /** As before, with a cause that a further attempt would meet again. */
    LOCATION_UPDATING_FORBIDDEN,
    AUTHENTICATION_REJECTED,
    /** A service was refused because the network has lost the registration. */
    FORGOTTEN_BY_NETWORK,
    /** The cell belongs to another location area. */
    NEW_AREA,
    CHANNEL_RELEASED,
    T3210_EXPIRED,
    T3211_EXPIRED,
    T3212_EXPIRED,
    T3220_EXPIRED
}
