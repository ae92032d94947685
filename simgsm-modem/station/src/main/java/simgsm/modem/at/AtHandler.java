package simgsm.modem.at;

/** Performs one form of a command. */
@FunctionalInterface
public interface AtHandler<C> {
    /**
     * @param client state of the client
     * @return the result; after {@link AtResult#PENDING} the request is finished later
     */
    AtResult perform(C client, AtRequest request) throws AtException;

    /** Performs and ends with OK. */
    @FunctionalInterface
    interface Simple<C> {
        void perform(C client, AtRequest request) throws AtException;
    }
}
