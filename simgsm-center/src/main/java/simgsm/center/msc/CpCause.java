package simgsm.center.msc;

/** Causes of CP-ERROR (TS 24.011, 8.1.4.2). */
final class CpCause {
    static final int INVALID_TRANSACTION_IDENTIFIER = 81;
    static final int NOT_COMPATIBLE_WITH_STATE = 98;

    private CpCause() {}
}
