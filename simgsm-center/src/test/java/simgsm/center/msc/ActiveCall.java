package simgsm.center.msc;

import simgsm.air.TransactionIdentifier;

/** Two mobiles that talk to each other. */
record ActiveCall(TestMobile caller, TestMobile called) {
    /** How the called mobile writes the first transaction that the network opens. */
    static final TransactionIdentifier CALLED_TRANSACTION = new TransactionIdentifier(0, true);
}
