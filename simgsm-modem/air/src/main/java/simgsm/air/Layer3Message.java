package simgsm.air;

/** A layer-3 message between a mobile and the network, by protocol discriminator (TS 24.007, 11.2.3.1.1). */
public sealed interface Layer3Message
        permits MobilityManagement, CallControl, RadioResource, ShortMessageControl, SupplementaryService {}
