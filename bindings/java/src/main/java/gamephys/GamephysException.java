package gamephys;

/** A call failed: the message is the library's, the status one of the constants Gamephys.ERROR_... */
public final class GamephysException extends RuntimeException {
    private static final long serialVersionUID = 1;
    private final int status;

    GamephysException(int status, String message) {
        super(message);
        this.status = status;
    }

    public int status() {
        return status;
    }
}
